#include "flexkey/gltf/playback.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace flexkey {

std::vector<VertexBlock> blocks_of(Eigen::Index vertices) {
  constexpr Eigen::Index size = 256;
  std::vector<VertexBlock> blocks;
  for (Eigen::Index first = 0; first < vertices; first += size) {
    blocks.push_back({first, std::min(size, vertices - first)});
  }
  return blocks;
}

ShapeRows deltas_of(const Motion& motion, VertexBlock block) {
  std::vector<int> vertices(static_cast<std::size_t>(block.count));
  std::iota(vertices.begin(), vertices.end(), static_cast<int>(block.first));
  return deltas_of(motion, vertices);
}

Playback::Playback(const Motion& motion, std::span<const double> keys, const Eigen::MatrixXf& weights)
    : motion_(motion) {
  const std::vector<double> frames(motion.numbers.begin(), motion.numbers.end());
  std::vector<double> times;
  std::set_union(frames.begin(), frames.end(), keys.begin(), keys.end(), std::back_inserter(times));
  solved_ = linear_sampler(frames, times);
  weights_ = (linear_sampler(keys, times) * weights.cast<double>()).cast<float>();
}

Eigen::VectorXd Playback::errors(VertexBlock block, const ShapeRows& deltas, const FloatRows& targets) const {
  using FloatRow = Eigen::Matrix<float, 1, Eigen::Dynamic>;
  const FloatRows block_rest = motion_.rest.middleRows(block.first, block.count).cast<float>();
  const Eigen::Map<const FloatRow> rest(block_rest.data(), block_rest.size());
  FloatRows played = rest.replicate(weights_.rows(), 1);
  if (targets.rows() > 0) played += weights_ * targets;
  const ShapeRows solved = solved_ * deltas;
  Eigen::VectorXd squared = Eigen::VectorXd::Zero(block.count);
  for (Eigen::Index row = 0; row < played.rows(); ++row) {
    const ShapeRow off = (played.row(row).cast<double>() - rest.cast<double>()) - solved.row(row);
    const Eigen::Map<const Positions> vectors(off.data(), block.count, 3);
    squared = squared.cwiseMax(vectors.rowwise().squaredNorm());
  }
  return squared.cwiseSqrt();
}

}  // namespace flexkey
