#include "flexkey/gltf/basis.h"

#include <gmock/gmock.h>

#include "flexkey/gltf/pca_basis.h"
#include "motions.h"

namespace flexkey {
namespace {

using namespace testing;  // NOLINT
using ::testing::ElementsAre;

TEST(Basis, HoldsEveryFrameAsItsOwnTarget) {
  Frames frames = frames_of(bent, evenly(4));
  frames.numbers = {0, 1, 2, 7, 8};
  const Basis basis = frame_basis(frames.motion());
  EXPECT_THAT(basis.names, ElementsAre("f0000", "f0001", "f0002", "f0007", "f0008"));
  EXPECT_THAT(basis.keys, ElementsAre(0, 1, 2, 7, 8));
  EXPECT_TRUE(weights_at_frames(basis, frames.numbers).isIdentity(0));
  EXPECT_LE(farthest_shown(basis, frames), kRounding);
}

TEST(Basis, BlendsWeightsByTimeAcrossAGap) {
  Basis basis;
  basis.keys = {2, 3, 7};
  basis.weights = Eigen::Vector3f(0, 1, 0.5F);
  const Eigen::MatrixXd weights = weights_at(basis, std::vector<double>{0, 2.25, 3, 4, 7, 9});
  EXPECT_TRUE(weights.isApprox(Eigen::Matrix<double, 6, 1>(0, 0.25, 1, 0.875, 0.5, 0.5)));
}

TEST(Basis, MeasuresWhatAClientShows) {
  const Frames frames = frames_of(bent, evenly(20));
  Basis basis = pca_basis(frames.motion(), 0.01);
  EXPECT_NEAR(largest_error(basis, frames.motion()), farthest_shown(basis, frames), kRounding);
  basis.targets[0](7, 1) += 2;  // of weight 1 at most
  EXPECT_GT(largest_error(basis, frames.motion()), 1.9);
  EXPECT_NEAR(largest_error(basis, frames.motion()), farthest_shown(basis, frames), kRounding);
}

TEST(Basis, MapsWeightsToTheUnitRange) {
  const Frames frames = frames_of(circled, joined(evenly(20), {-1, -0.5, 0}));
  const Basis basis = pca_basis(frames.motion(), 1e-4);
  ASSERT_LT(basis.weights.minCoeff(), 0);
  const Basis mapped = with_weights_in_unit_range(basis);
  EXPECT_GE(mapped.weights.minCoeff(), 0);
  EXPECT_LE(mapped.weights.maxCoeff(), 1);
  EXPECT_EQ(mapped.targets.size(), basis.targets.size() + 1);
  EXPECT_EQ(mapped.names.back(), "mean");
  EXPECT_TRUE((mapped.weights.rightCols(1).array() == 1).all());
  EXPECT_LE(farthest_shown(mapped, frames), farthest_shown(basis, frames) + kRounding);
}

TEST(Basis, LeavesWeightsOfTheUnitRangeAsTheyAre) {
  const Basis basis = frame_basis(frames_of(bent, evenly(4)).motion());
  EXPECT_EQ(with_weights_in_unit_range(basis).names, basis.names);
}

}  // namespace
}  // namespace flexkey
