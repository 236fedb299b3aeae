#include "flexkey/gltf/quantize.h"

#include <gtest/gtest.h>

#include <cmath>

namespace flexkey::testing {
namespace {

/// Rows that look like noise, of this size, the same each time.
FloatRows noise(Eigen::Index rows, double size, int seed) {
  FloatRows result(rows, 3);
  for (Eigen::Index i = 0; i < result.size(); ++i)
    result.data()[i] = static_cast<float>(size * std::sin(12.9898 * static_cast<double>(i + 1) * (seed + 1)));
  return result;
}

MorphTargets targets_of(double position_size, double normal_size) {
  MorphTargets targets;
  for (const int t : {0, 1, 2}) {
    targets.positions.push_back(noise(500, position_size / (1 + t), t));
    targets.normals.push_back(noise(500, normal_size / (1 + t), t + 7));
  }
  return targets;
}

const Eigen::MatrixXf unit_weights = Eigen::MatrixXf::Identity(3, 3);

double off(const FloatRows& deltas, const ShortRows& integers, double scale, double largest) {
  const Eigen::MatrixXd played = integers.cast<double>() * (scale / largest);
  return (played - deltas.cast<double>()).rowwise().norm().maxCoeff();
}

TEST(Quantize, KeepsToTheBudgetsOfPositionsAndNormals) {
  const MorphTargets targets = targets_of(0.4, 1.2);
  const QuantizedTargets quantized = quantize(targets, unit_weights, {.length = 1e-4, .angle = 0.01});
  EXPECT_EQ(quantized.normal_largest, 127);
  for (std::size_t t = 0; t < 3; ++t) {
    EXPECT_LT(off(targets.positions[t], quantized.positions[t], quantized.scales[t], 32767), 3e-4);
    EXPECT_LT(off(targets.normals[t], quantized.normals[t], quantized.scales[t], 127), 0.03);
  }
}

TEST(Quantize, AnIntegerIsWithinTheRangeOfItsType) {
  const QuantizedTargets quantized = quantize(targets_of(0.4, 1.2), unit_weights, {.length = 1e-4});
  for (const ShortRows& normals : quantized.normals) EXPECT_LE(normals.cwiseAbs().maxCoeff(), 127);
  for (const ShortRows& positions : quantized.positions) {
    EXPECT_LE(positions.cast<int>().cwiseAbs().maxCoeff(), 32767);
    EXPECT_GT(positions.cast<int>().cwiseAbs().maxCoeff(), 100) << "steps finer than the target itself";
  }
}

TEST(Quantize, AMeshInCentimetresNeedsNormalsOfTwoBytes) {
  const MorphTargets targets = targets_of(100, 1.2);
  const QuantizedTargets quantized = quantize(targets, unit_weights, {.length = 0.02, .angle = 0.01});
  EXPECT_EQ(quantized.normal_largest, 32767);
  ASSERT_EQ(quantized.normals.size(), 3u);
  for (std::size_t t = 0; t < 3; ++t)
    EXPECT_LT(off(targets.normals[t], quantized.normals[t], quantized.scales[t], 32767), 0.03);
}

TEST(Quantize, ATinyMeshKeepsNormalsInFloats) {
  const MorphTargets targets = targets_of(1e-5, 1.2);
  const QuantizedTargets quantized = quantize(targets, unit_weights, {.length = 1e-9, .angle = 0.01});
  EXPECT_TRUE(quantized.normals.empty());
  ASSERT_EQ(quantized.float_normals.size(), 3u);
  for (std::size_t t = 0; t < 3; ++t) {
    EXPECT_LT(off(targets.positions[t], quantized.positions[t], quantized.scales[t], 32767), 3e-9);
    const FloatRows played = quantized.float_normals[t] * quantized.scales[t];
    EXPECT_LT((played - targets.normals[t]).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST(Quantize, ATargetOfZerosStaysZero) {
  MorphTargets still;
  still.positions.emplace_back(FloatRows::Zero(4, 3));
  const QuantizedTargets quantized = quantize(still, Eigen::MatrixXf::Zero(2, 1), {.length = 0});
  EXPECT_TRUE(quantized.positions[0].isZero(0));
  EXPECT_GT(quantized.scales[0], 0);
  EXPECT_TRUE(std::isfinite(quantized.scales[0]));
}

}  // namespace
}  // namespace flexkey::testing
