#include "flexkey/gltf/basis.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "flexkey/gltf/playback.h"

namespace flexkey {
namespace {

/// A block's part of all targets, #targets x 3 #block.
FloatRows side_by_side(const std::vector<FloatRows>& targets, VertexBlock block) {
  FloatRows rows(std::ssize(targets), 3 * block.count);
  for (Eigen::Index t = 0; t < rows.rows(); ++t) {
    Eigen::Map<FloatRows>(rows.row(t).data(), block.count, 3) =
        targets[static_cast<std::size_t>(t)].middleRows(block.first, block.count);
  }
  return rows;
}

}  // namespace

std::string target_name(int frame) {
  return fmt::format("f{:04}", frame);
}

Basis frame_basis(const Motion& motion) {
  const auto frames = static_cast<Eigen::Index>(motion.frames.size());
  Basis basis{
      {}, {motion.numbers.begin(), motion.numbers.end()}, Eigen::MatrixXf::Identity(frames, frames), {}};
  const FloatRows rest = motion.rest.cast<float>();
  for (std::size_t frame = 0; frame < motion.frames.size(); ++frame) {
    basis.targets.emplace_back(motion.frames[frame].cast<float>() - rest);
    basis.names.push_back(target_name(motion.numbers[frame]));
  }
  return basis;
}

Eigen::MatrixXd weights_at(const Basis& basis, std::span<const double> times) {
  return linear_sampler(basis.keys, times) * basis.weights.cast<double>();
}

Eigen::MatrixXd weights_at_frames(const Basis& basis, std::span<const int> numbers) {
  return weights_at(basis, std::vector<double>(numbers.begin(), numbers.end()));
}

double largest_error(const Basis& basis, const Motion& motion) {
  const Playback playback(motion, basis.keys, basis.weights);
  const std::vector<VertexBlock> blocks = blocks_of(motion.rest.rows());
  std::vector<double> largest(blocks.size());
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
    const FloatRows targets = side_by_side(basis.targets, blocks[i]);
    largest[i] = playback.errors(blocks[i], deltas_of(motion, blocks[i]), targets).maxCoeff();
  });
  return largest.empty() ? 0 : *std::max_element(largest.begin(), largest.end());
}

Basis with_weights_in_unit_range(const Basis& basis) {
  const Eigen::MatrixXf& weights = basis.weights;
  if (weights.size() == 0 || (weights.minCoeff() >= 0 && weights.maxCoeff() <= 1)) return basis;
  const Eigen::RowVectorXf low = weights.colwise().minCoeff().cwiseMin(0.0F);
  const Eigen::RowVectorXf high = weights.colwise().maxCoeff().cwiseMax(1.0F);
  Basis mapped = basis;
  FloatRows mean = FloatRows::Zero(basis.targets[0].rows(), 3);
  for (std::size_t t = 0; t < basis.targets.size(); ++t) {
    const auto column = static_cast<Eigen::Index>(t);
    const float range = high[column] - low[column];
    mean += low[column] * basis.targets[t];
    mapped.targets[t] *= range;
    mapped.weights.col(column) = ((weights.col(column).array() - low[column]) / range).cwiseMin(1.0F);
  }
  mapped.targets.push_back(std::move(mean));
  mapped.names.emplace_back("mean");
  mapped.weights.conservativeResize(Eigen::NoChange, weights.cols() + 1);
  mapped.weights.rightCols(1).setOnes();
  return mapped;
}

}  // namespace flexkey
