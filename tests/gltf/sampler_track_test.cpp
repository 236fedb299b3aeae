#include "flexkey/gltf/sampler_track.h"

#include <gtest/gtest.h>

#include <vector>

namespace flexkey::testing {
namespace {

FloatRows column(const std::vector<float>& values) {
  return Eigen::Map<const Eigen::VectorXf>(values.data(), static_cast<Eigen::Index>(values.size()));
}

SamplerTrack track(const std::string& interpolation, const std::vector<float>& times,
                   const std::vector<float>& values) {
  return {interpolation, column(times), column(values)};
}

TEST(SamplerTrack, ValuesHoldBeforeTheFirstKeyAndAfterTheLast) {
  for (const char* interpolation : {"LINEAR", "STEP"}) {
    const SamplerTrack ramp = track(interpolation, {1, 3}, {5, 9});
    EXPECT_EQ(sample(ramp, 0)(0), 5);
    EXPECT_EQ(sample(ramp, 1)(0), 5);
    EXPECT_EQ(sample(ramp, 3)(0), 9);
    EXPECT_EQ(sample(ramp, 7)(0), 9);
  }
  EXPECT_EQ(sample(track("LINEAR", {1, 3}, {5, 9}), 1.5)(0), 6);
  EXPECT_EQ(sample(track("STEP", {1, 3}, {5, 9}), 2.9F)(0), 5);
}

TEST(SamplerTrack, ACubicSplineFollowsItsTangents) {
  // v = t³ between 0 and 2: tangents 0 and 12.
  const SamplerTrack cube = track("CUBICSPLINE", {0, 2}, {0, 0, 0, 12, 8, 0});
  for (const float t : {0.0F, 0.5F, 1.0F, 1.7F, 2.0F}) EXPECT_NEAR(sample(cube, t)(0), t * t * t, 1e-5) << t;
}

TEST(SamplerTrack, PaddingAddsZerosBehind) {
  const SamplerTrack wide = padded(track("CUBICSPLINE", {0, 2}, {1, 2, 3, 4, 5, 6}), 2);
  EXPECT_EQ(wide.values.cols(), 3);
  EXPECT_EQ(wide.values.col(0), column({1, 2, 3, 4, 5, 6}));
  EXPECT_TRUE(wide.values.rightCols(2).isZero(0));
}

TEST(SamplerTrack, SideBySideIsBothTracksAtOnce) {
  const SamplerTrack a = track("LINEAR", {0, 1, 4}, {0, 2, 8}), b = track("LINEAR", {0, 2, 3}, {1, 0, 5});
  const SamplerTrack both = side_by_side(a, b);
  EXPECT_EQ(both.times, column({0, 1, 2, 3, 4}));
  for (const float t : {0.0F, 0.25F, 1.0F, 1.5F, 2.5F, 3.5F, 9.0F}) {
    const Eigen::RowVectorXf values = sample(both, t);
    EXPECT_FLOAT_EQ(values(0), sample(a, t)(0)) << t;
    EXPECT_FLOAT_EQ(values(1), sample(b, t)(0)) << t;
  }
}

TEST(SamplerTrack, AStepStaysAStepBesideARamp) {
  const SamplerTrack both = side_by_side(track("STEP", {0, 1}, {3, 7}), track("LINEAR", {0, 2}, {0, 2}));
  EXPECT_EQ(sample(both, 0.999F)(0), 3);
  EXPECT_EQ(sample(both, 1)(0), 7);
  EXPECT_EQ(sample(both, 2)(0), 7);
}

}  // namespace
}  // namespace flexkey::testing
