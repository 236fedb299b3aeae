#include "flexkey/gltf/pca_basis.h"

#include <gmock/gmock.h>

#include "motions.h"

namespace flexkey {
namespace {

using namespace testing;  // NOLINT
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(PcaBasis, PlaysWithinTheToleranceAtFramesAndBetween) {
  const Frames frames = frames_of(bent, joined(eased(evenly(40)), reversed(eased(evenly(29)))));
  std::size_t before = 0;
  for (const double tolerance : {0.3, 0.02, 0.001}) {
    const Basis basis = pca_basis(frames.motion(), tolerance);
    EXPECT_LE(farthest_shown(basis, frames), tolerance) << tolerance;
    EXPECT_GT(basis.targets.size(), before) << tolerance;
    EXPECT_LT(basis.targets.size(), 10U) << tolerance;
    before = basis.targets.size();
  }
}

TEST(PcaBasis, TakesAsManyTargetsAsTheMotionHasDimensions) {
  const Frames circle = frames_of(circled, evenly(30)), line = frames_of(stretched, eased(evenly(30)));
  EXPECT_THAT(pca_basis(circle.motion(), 1e-4).names, ElementsAre("pca_000", "pca_001"));
  EXPECT_THAT(pca_basis(line.motion(), 1e-4).names, ElementsAre("pca_000"));
}

TEST(PcaBasis, GivesWeightsALargestMagnitudeOfOne) {
  const Basis basis = pca_basis(frames_of(circled, evenly(30)).motion(), 1e-4);
  for (Eigen::Index t = 0; t < basis.weights.cols(); ++t) {
    EXPECT_EQ(basis.weights.col(t).maxCoeff(), 1);
    EXPECT_GE(basis.weights.col(t).minCoeff(), -1);
  }
}

TEST(PcaBasis, LeavesOutKeysOfAHold) {
  const Frames frames = frames_of(bent, joined(evenly(10), std::vector<double>(40, 1.0)));
  const Basis basis = pca_basis(frames.motion(), 0.01);
  EXPECT_LE(basis.keys.size(), 13U);
  EXPECT_EQ(basis.keys.back(), 50);
  EXPECT_LE(farthest_shown(basis, frames), 0.01);
}

TEST(PcaBasis, TakesShortClipsAndRest) {
  EXPECT_EQ(pca_basis(frames_of(bent, {1}).motion(), 0).targets.size(), 1U);
  EXPECT_EQ(pca_basis(frames_of(bent, {0.5, 0.5}).motion(), 0).targets.size(), 1U);
  EXPECT_THAT(pca_basis(frames_of(bent, {0, 0}).motion(), 0).targets, IsEmpty());
}

TEST(PcaBasis, IsExactToFloatsWithoutATolerance) {
  const Frames frames = frames_of(bent, eased(evenly(25)));
  EXPECT_LE(farthest_shown(pca_basis(frames.motion(), 0), frames), kRounding);
}

TEST(PcaBasis, HonoursGapsBetweenFrames) {
  Frames frames = frames_of(bent, evenly(31));
  frames.numbers.back() = 47;
  const Basis basis = pca_basis(frames.motion(), 0.02);
  EXPECT_EQ(basis.keys.back(), 47);
  EXPECT_LE(farthest_shown(basis, frames), 0.02);
}

}  // namespace
}  // namespace flexkey
