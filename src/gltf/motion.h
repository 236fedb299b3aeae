#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "flexkey/mesh/types.h"

namespace flexkey {

/// The solved frames of a mesh, as morph targets are to play them: at least one frame and one vertex.
struct Motion {
  std::span<const Positions> frames;  // #frames of #V x 3, file units
  const Positions& rest;              // #V x 3, what clients add the targets to, after rounding to floats
  std::span<const int> numbers;       // #frames, strictly increasing: frame k is at numbers[k] / fps
};

/// Shapes as rows, three numbers a vertex: #shapes x 3 #vertices.
using ShapeRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using ShapeRow = Eigen::RowVectorXd;  // 1 x 3 #vertices

/// How far some vertices are from the rest shape's floats, #frames x 3 #vertices.
ShapeRows deltas_of(const Motion& motion, std::span<const int> vertices);

/// How far each vertex is from rest where it is farthest, #V.
Eigen::VectorXd reaches_of(const Motion& motion);

/// The largest of a shape's vertex vectors, and of each row's.
double largest_length(const Eigen::Ref<const ShapeRow>& shape);
Eigen::VectorXd largest_lengths(const ShapeRows& shapes);

/// What a LINEAR sampler plays at `times` of values given at `keys`, which strictly increase: a matrix of
/// #times x #keys to multiply the values with. Before the first key and after the last they hold.
Eigen::SparseMatrix<double, Eigen::RowMajor> linear_sampler(std::span<const double> keys,
                                                            std::span<const double> times);

}  // namespace flexkey
