#include "flexkey/gltf/weight_tracks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "flexkey/gltf/basis.h"
#include "flexkey/mesh/error.h"
#include "gltf/clips.h"
#include "gltf/glb_file.h"

namespace flexkey::testing {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;

Clip four_a_second(int frames) {
  Clip clip = clip_of(cube(), frames, twist);
  clip.fps = 4;
  return clip;
}

Basis basis_of(const Clip& clip) {
  std::vector<int> numbers;
  for (const FrameReport& report : clip.reports) numbers.push_back(report.frame);
  return frame_basis({clip.frames, clip.mesh.positions, numbers});
}

TEST(WeightTracks, WithoutRangesThereIsOneOfTheWholeClip) {
  const Clip clip = four_a_second(3);
  const std::vector<WeightTrack> tracks = weight_tracks(clip, basis_of(clip), {});
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_EQ(tracks[0].name, "test shot");
  EXPECT_THAT(tracks[0].times, ElementsAre(0, 0.25, 0.5));
  EXPECT_EQ(tracks[0].weights, Eigen::MatrixXf::Identity(3, 3));
}

TEST(WeightTracks, ARangeBeginsAtZeroAndEndsBetweenFrames) {
  const Clip clip = four_a_second(5);
  const std::vector<WeightTrack> tracks =
      weight_tracks(clip, basis_of(clip), {{"in", 0, 0.5}, {"out", 0.375, 0.875}});
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[1].name, "out");
  EXPECT_THAT(tracks[0].times, ElementsAre(0, 0.25, 0.5));
  EXPECT_THAT(tracks[1].times, ElementsAre(0, DoubleEq(0.125), DoubleEq(0.375), DoubleEq(0.5)));
  Eigen::MatrixXf out(4, 5);
  out << 0, 0.5, 0.5, 0, 0,  //
      0, 0, 1, 0, 0,         //
      0, 0, 0, 1, 0,         //
      0, 0, 0, 0.5, 0.5;
  EXPECT_EQ(tracks[1].weights, out);
}

TEST(WeightTracks, ARangeIsCutToTheClip) {
  const Clip clip = four_a_second(3);
  const std::vector<WeightTrack> tracks = weight_tracks(clip, basis_of(clip), {{"long", -1, 9}});
  EXPECT_THAT(tracks[0].times, ElementsAre(0, 0.25, 0.5));
}

TEST(WeightTracks, OfACycleEndWithTheFirstWeights) {
  Clip clip = four_a_second(3);
  clip.period = 3;
  const WeightTrack whole = weight_tracks(clip, basis_of(clip), {}).at(0);
  EXPECT_THAT(whole.times, ElementsAre(0, 0.25, 0.5, 0.75));
  EXPECT_EQ(whole.to, 0.75);
  EXPECT_EQ(whole.weights.bottomRows(1), whole.weights.topRows(1));
  const WeightTrack end = weight_tracks(clip, basis_of(clip), {{"end", 0.5, 2}}).at(0);
  EXPECT_THAT(end.times, ElementsAre(0, 0.25));
  EXPECT_EQ(end.weights.bottomRows(1), whole.weights.topRows(1));
  clip.period = 4;  // of which a frame is not written
  EXPECT_THAT(weight_tracks(clip, basis_of(clip), {}).at(0).times, ElementsAre(0, 0.25, 0.5));
}

TEST(WeightTracks, SomeFramesOfAShotCountInItsTime) {
  Clip clip = four_a_second(3);
  for (FrameReport& report : clip.reports) report.frame += 8;  // from 2 s
  const std::vector<WeightTrack> tracks = weight_tracks(clip, basis_of(clip), {{"late", 2.25, 2.5}});
  EXPECT_THAT(tracks[0].times, ElementsAre(0, 0.25));
  EXPECT_THROW(weight_tracks(clip, basis_of(clip), {{"early", 0, 1}}), InputError);
}

TEST(WeightTracks, AFileHasAnAnimationEach) {
  const TemporaryFolder folder;
  GltfOptions options = exact();
  options.clips = {{"in", 0, 0.5}, {"out", 0.5, 1}};
  write_glb(four_a_second(5), options, folder / "shot.glb");
  const tinygltf::Model model = load_glb(folder / "shot.glb");
  ASSERT_EQ(model.animations.size(), 2u);
  EXPECT_EQ(model.animations[0].name, "in");
  EXPECT_EQ(model.animations[1].name, "out");
  EXPECT_EQ(model.meshes[0].primitives[0].targets.size(), 5u);
}

}  // namespace
}  // namespace flexkey::testing
