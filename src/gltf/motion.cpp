#include "flexkey/gltf/motion.h"

#include <algorithm>
#include <cmath>

namespace flexkey {

ShapeRows deltas_of(const Motion& motion, std::span<const int> vertices) {
  ShapeRows deltas(static_cast<Eigen::Index>(motion.frames.size()),
                   3 * static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t frame = 0; frame < motion.frames.size(); ++frame) {
    double* out = deltas.row(static_cast<Eigen::Index>(frame)).data();
    for (const int vertex : vertices) {
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        *out++ = motion.frames[frame](vertex, axis) -
                 static_cast<double>(static_cast<float>(motion.rest(vertex, axis)));
      }
    }
  }
  return deltas;
}

Eigen::VectorXd reaches_of(const Motion& motion) {
  const Positions rest = motion.rest.cast<float>().cast<double>();
  Eigen::VectorXd squared = Eigen::VectorXd::Zero(rest.rows());
  for (const Positions& frame : motion.frames) {
    squared = squared.cwiseMax((frame - rest).rowwise().squaredNorm());
  }
  return squared.cwiseSqrt();
}

double largest_length(const Eigen::Ref<const ShapeRow>& shape) {
  double squared = 0;
  for (const double* at = shape.data(); at != shape.data() + shape.size(); at += 3) {
    squared = std::max(squared, at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
  }
  return std::sqrt(squared);
}

Eigen::VectorXd largest_lengths(const ShapeRows& shapes) {
  Eigen::VectorXd lengths(shapes.rows());
  for (Eigen::Index row = 0; row < shapes.rows(); ++row) lengths[row] = largest_length(shapes.row(row));
  return lengths;
}

Eigen::SparseMatrix<double, Eigen::RowMajor> linear_sampler(std::span<const double> keys,
                                                            std::span<const double> times) {
  Eigen::SparseMatrix<double, Eigen::RowMajor> sampler(std::ssize(times), std::ssize(keys));
  sampler.reserve(Eigen::VectorXi::Constant(std::ssize(times), 2));
  for (std::ptrdiff_t row = 0; row < std::ssize(times); ++row) {
    const double time = std::clamp(times[static_cast<std::size_t>(row)], keys.front(), keys.back());
    const auto after = std::upper_bound(keys.begin(), keys.end(), time);
    const auto left = after - keys.begin() - 1;
    const double from = keys[static_cast<std::size_t>(left)];
    const double share = after == keys.end() ? 0 : (time - from) / (*after - from);
    sampler.insert(row, left) = 1 - share;
    if (share > 0) sampler.insert(row, left + 1) = share;
  }
  return sampler;
}

}  // namespace flexkey
