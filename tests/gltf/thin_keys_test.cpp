#include "flexkey/gltf/thin_keys.h"

#include <gmock/gmock.h>

namespace flexkey {
namespace {

using ::testing::ElementsAre;

/// One vertex, one target a unit long along each axis.
const ShapeRows kAxes = ShapeRows::Identity(3, 3);

TEST(ThinKeys, KeepsCornersAndEnds) {
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(6, 3);
  weights.col(0) << 0, 0.1, 0.2, 0.5, 0.5, 0.5;
  EXPECT_THAT(kept_keys({0, 1, 2, 5, 6, 7}, weights, kAxes, 1e-9), ElementsAre(0, 3, 5));
  EXPECT_THAT(kept_keys({0, 1, 2, 3, 4, 5}, weights, kAxes, 1e-9), ElementsAre(0, 2, 3, 5));
  EXPECT_THAT(kept_keys({0, 1, 2, 3, 4, 5}, weights, kAxes, 1), ElementsAre(0, 5));
}

TEST(ThinKeys, NeverMakesMoreTargetsActive) {
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(3, 3);
  weights.diagonal().setConstant(1e-6);
  EXPECT_THAT(kept_keys({0, 1, 2}, weights, kAxes, 1), ElementsAre(0, 1, 2));
}

TEST(ThinKeys, TakesOneKey) {
  EXPECT_THAT(kept_keys({4}, Eigen::MatrixXd::Zero(1, 3), kAxes, 1), ElementsAre(0));
}

}  // namespace
}  // namespace flexkey
