#pragma once

#include <Eigen/Core>

#include "flexkey/gltf/motion.h"
#include "flexkey/gltf/walk.h"

namespace flexkey {

/// A walk with its nodes moved so that the frames lie near its ways. Node 0, rest, is no target.
struct WalkFit {
  Eigen::MatrixXd weights;  // #frames x #targets
  Eigen::MatrixXd fit;      // #targets x #frames; targets = fit · shapes
  double error = 0;         // largest vertex distance at a frame or a visit
};

/// Moves the nodes off their frames by least squares, and then towards the smallest largest error by giving
/// more importance to the frames that are farther off (C. L. Lawson, "Contributions to the theory of linear
/// least maximum approximation", 1961), until within the tolerance.
WalkFit fit_walk(const Walk& walk, const ShapeRows& shapes, double tolerance);

}  // namespace flexkey
