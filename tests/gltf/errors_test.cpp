#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <limits>

#include "flexkey/gltf/write_glb.h"
#include "flexkey/mesh/error.h"
#include "gltf/clips.h"

namespace flexkey::testing {
namespace {

using ::testing::HasSubstr;

template <typename Failure>
std::string message_of(const Clip& clip, const std::filesystem::path& path) {
  try {
    write_glb(clip, exact(), path);
  } catch (const Failure& error) {
    return error.what();
  }
  return "no error";
}

std::string refusal(const Clip& clip) {
  const TemporaryFolder folder;
  const std::string message = message_of<InputError>(clip, folder / "shot.glb");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  return message;
}

TEST(WriteErrors, AFullDiskIsAnError) {
  EXPECT_THAT(message_of<OutputError>(clip_of(cube(), 4, twist), "/dev/full"), HasSubstr("No space left"));
}

TEST(WriteErrors, AFileInTheFoldersPlaceIsAnError) {
  const TemporaryFolder folder;
  std::ofstream(folder / "taken") << "text";
  EXPECT_THAT(message_of<OutputError>(clip_of(cube(), 4, twist), folder / "taken/shot.glb"),
              HasSubstr("taken"));
}

TEST(WriteErrors, AFolderInTheFilesPlaceIsAnError) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "shot.glb");
  EXPECT_THAT(message_of<OutputError>(clip_of(cube(), 4, twist), folder / "shot.glb"),
              HasSubstr("directory"));
}

TEST(WriteErrors, AWriteThatStopsHalfWayLeavesTheOldFile) {
  const TemporaryFolder folder;
  std::ofstream(folder / "shot.glb") << "the old one";
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit{};
  getrlimit(RLIMIT_FSIZE, &old_limit);
  rlimit limit = old_limit;
  limit.rlim_cur = 5000;
  setrlimit(RLIMIT_FSIZE, &limit);
  const std::string message = message_of<OutputError>(clip_of(sheet(12), 10, twist), folder / "shot.glb");
  setrlimit(RLIMIT_FSIZE, &old_limit);
  std::signal(SIGXFSZ, old_handler);

  EXPECT_THAT(message, HasSubstr("too large"));
  std::string kept;
  std::getline(std::ifstream(folder / "shot.glb"), kept);
  EXPECT_EQ(kept, "the old one");
  const auto files = std::filesystem::directory_iterator(folder.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST(WriteErrors, PositionsMustBeFiniteFloats) {
  Clip clip = clip_of(cube(), 4, twist);
  clip.frames[2](5, 1) = std::nan("");
  EXPECT_THAT(refusal(clip), HasSubstr("vertex 5 of frame 2 is at"));
  clip.frames[2](5, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THAT(refusal(clip), HasSubstr("vertex 5 of frame 2 is at"));
  clip.frames[2](5, 1) = 1e39;
  EXPECT_THAT(refusal(clip), HasSubstr("vertex 5 of frame 2 is at"));
  clip = clip_of(cube(), 4, twist);
  clip.mesh.positions(0, 0) = -1e300;
  EXPECT_THAT(refusal(clip), HasSubstr("vertex 0 of the rest mesh is at"));
}

TEST(WriteErrors, FramesMustBeThereAndNotTooMany) {
  EXPECT_EQ(refusal(clip_of(cube(), 0, twist)), "the clip has no frames");
  EXPECT_THAT(refusal(clip_of(cube(), 201, twist)),
              HasSubstr("201 morph targets as 'exact', and at most 200 are allowed"));
  GltfOptions options = exact();
  options.max_targets = 201;
  const TemporaryFolder folder;
  EXPECT_EQ(write_glb(clip_of(cube(), 201, twist), options, folder / "shot.glb").targets, 201);
}

TEST(WriteErrors, PartsMustFitEachOther) {
  Clip clip = clip_of(cube(), 4, twist);
  clip.frames[3].conservativeResize(7, 3);
  EXPECT_EQ(refusal(clip), "frame 3 has 7 vertices, the mesh has 8");
  clip = clip_of(cube(), 4, twist);
  clip.reports.pop_back();
  EXPECT_EQ(refusal(clip), "the clip has 4 frames and 3 reports of them");
  clip = clip_of(cube(), 4, twist);
  clip.reports[2].frame = 9;
  EXPECT_EQ(refusal(clip), "frame 3 comes after frame 9");
  clip = clip_of(cube(), 4, twist);
  clip.mesh.corners[3] = 8;
  EXPECT_EQ(refusal(clip), "a face of the mesh names a vertex that is not there");
  clip = clip_of(cube(), 4, twist);
  clip.mesh.face_offsets.back() = 25;
  EXPECT_EQ(refusal(clip), "the faces of the mesh do not match its corners");
  clip = clip_of(cube(), 4, twist);
  clip.mesh.face_material.assign(6, 0);
  EXPECT_EQ(refusal(clip), "a face names a material that is not there");
  clip = clip_of(cube(), 4, twist);
  clip.mesh.corner_texcoord.assign(24, 0);
  EXPECT_EQ(refusal(clip), "a corner names a texture coordinate that is not there");
  clip = clip_of(cube(), 4, twist);
  clip.mesh.add_face(std::array{0, 1});
  EXPECT_EQ(refusal(clip), "face 6 of the mesh has fewer than three corners");
}

TEST(WriteErrors, TheFrameRateMustMakeTimesOfFloats) {
  for (const double fps : {0.0, -24.0, 1e-300, 1e300, std::nan("")}) {
    Clip clip = clip_of(cube(), 4, twist);
    clip.fps = fps;
    EXPECT_THAT(refusal(clip), HasSubstr("out of glTF's reach")) << fps;
  }
}

}  // namespace
}  // namespace flexkey::testing
