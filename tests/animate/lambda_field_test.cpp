#include "flexkey/animate/lambda_field.h"

#include <gtest/gtest.h>

#include "animate/shots.h"
#include "flexkey/animate/animate.h"

namespace flexkey {
namespace {

using test::shot_of;

/// λ along the bar, a number for each of its heights 0..8.
std::vector<double> lambda_by_height(const std::string& lambda, double time = 0) {
  const Mesh bar = meshes::bar(2, 2, 8);
  const Shot shot = shot_of(test::held_bar + "lambda: " + lambda + "\n");
  const Scene scene = bind_shot(shot, bar);
  const Eigen::VectorXd field = lambda_at(shot, scene, time);
  std::vector<double> by_height(9);
  for (int v = 0; v < scene.weld.surface.vertex_count(); ++v)
    by_height[static_cast<std::size_t>(std::lround(scene.weld.surface.positions(v, 2)))] = field[v];
  return by_height;
}

TEST(LambdaRegion, HasItsValueInsideAndNothingOutside) {
  const std::vector<double> lambda =
      lambda_by_height("{keys: {0s: 0.25}, regions: [{select: {axis: z, above: 5}, value: 1}]}");
  EXPECT_EQ(lambda, (std::vector<double>{0.25, 0.25, 0.25, 0.25, 0.25, 1, 1, 1, 1}));
}

TEST(LambdaRegion, FeathersBySmoothstepOfTheDistanceAlongTheSurface) {
  const std::vector<double> lambda =
      lambda_by_height("{keys: {0s: 0}, regions: [{select: {axis: z, above: 6}, value: 0.8, feather: 4}]}");
  const auto smoothstep = [](double s) { return s * s * (3 - 2 * s); };
  EXPECT_EQ(lambda[6], 0.8);
  EXPECT_NEAR(lambda[5], 0.8 * smoothstep(0.75), 1e-9);
  EXPECT_NEAR(lambda[4], 0.8 * smoothstep(0.5), 1e-9);
  EXPECT_NEAR(lambda[3], 0.8 * smoothstep(0.25), 1e-9);
  EXPECT_NEAR(lambda[2], 0, 1e-9);
}

TEST(LambdaRegion, LaterRegionsWinAndValuesFollowTime) {
  const std::string regions =
      "{keys: {0s: 0}, regions: [{select: {axis: z, above: 4}, value: {0s: 0, 2s: 1}}, "
      "{select: {axis: z, above: 7}, value: 0.3}]}";
  EXPECT_EQ(lambda_by_height(regions, 1), (std::vector<double>{0, 0, 0, 0, 0.5, 0.5, 0.5, 0.3, 0.3}));
  EXPECT_EQ(lambda_by_height("{regions: [{select: {axis: z, above: 8}, value: 1}]}")[0], 0.5)
      << "the default elsewhere";
}

TEST(LambdaRegion, ChangesTheShapeThereAndAWholeOneIsThatLambda) {
  const Mesh bar = meshes::bar(2, 2, 8);
  const std::string tip =
      "  tip: {select: {axis: z, above: 100%}, rotate: {axis: x, keys: {0s: 0deg, 0.25s: 40deg}}}\n";
  const auto last = [&](const std::string& lambda) {
    return animate(shot_of(test::held_bar + tip + "lambda: " + lambda + "\n"), bar).frames.back();
  };
  const Positions smooth = last("0"), rigid = last("1");
  const Positions part = last("{keys: {0s: 0}, regions: [{select: {axis: z, above: 5}, value: 1}]}");
  EXPECT_GT((part - smooth).rowwise().norm().maxCoeff(), 1e-3);
  EXPECT_GT((part - rigid).rowwise().norm().maxCoeff(), 1e-3);
  EXPECT_EQ(last("{keys: {0s: 0}, regions: [{select: {axis: z, above: 0}, value: 1}]}"), rigid);
}

TEST(LambdaRegion, WhatIsWrongIsSaidWithItsPlace) {
  const auto message = [](const std::string& lambda) -> std::string {
    try {
      bind_shot(shot_of(test::held_bar + "lambda: " + lambda + "\n"), meshes::bar(2, 2, 8));
    } catch (const TimelineError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(message("{regions: [{value: 1}]}"), "shot.yaml:4:20: error: a region of 'lambda' needs 'select'");
  EXPECT_EQ(message("{regions: [{select: {axis: z, above: 5}, value: 1.5}]}"),
            "shot.yaml:4:57: error: lambda 1.5 is outside 0..1 (0 smooth, 1 most rigid)");
  EXPECT_EQ(message("{regions: {select: {axis: z, above: 5}, value: 1}}"),
            "shot.yaml:4:19: error: 'regions' is a list of {select: {group: nose}, value: 1, feather: 2%}, "
            "not a mapping");
  EXPECT_EQ(message("{regions: [{select: {axis: z, above: 5}, value: 1, feather: -1}]}"),
            "shot.yaml:4:69: error: length -1 is below 0");
  EXPECT_NE(
      message("{regions: [{select: {group: nose}, value: 1}]}").find("4:37: error: a region of 'lambda': "),
      std::string::npos);
}

}  // namespace
}  // namespace flexkey
