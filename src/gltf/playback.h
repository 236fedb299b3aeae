#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "flexkey/gltf/float_rows.h"
#include "flexkey/gltf/motion.h"

namespace flexkey {

/// Vertices that are worked on together: all frames of a few hundred fit into the processor's cache.
struct VertexBlock {
  Eigen::Index first = 0, count = 0;
};
std::vector<VertexBlock> blocks_of(Eigen::Index vertices);

/// Frames minus rest (see deltas_of) of a block.
ShapeRows deltas_of(const Motion& motion, VertexBlock block);

/// Compares what a client plays of some targets with what was solved: at all frames and at the keys between
/// them, where the solved frames are blended linearly. Both are linear in between.
class Playback {
 public:
  /// keys: times as in Basis; weights: #keys x #targets. The motion must outlive the playback.
  Playback(const Motion& motion, std::span<const double> keys, const Eigen::MatrixXf& weights);

  /// Each vertex's largest distance over time, #block. Targets are added to rest in floats, as clients do.
  /// targets: #targets x 3 #block, deltas from rest.
  Eigen::VectorXd errors(VertexBlock block, const ShapeRows& deltas, const FloatRows& targets) const;

 private:
  const Motion& motion_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> solved_;  // #times x #frames
  FloatRows weights_;                                    // #times x #targets
};

}  // namespace flexkey
