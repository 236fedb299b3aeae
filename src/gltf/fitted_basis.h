#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "flexkey/gltf/basis.h"
#include "flexkey/gltf/motion.h"

namespace flexkey {

/// A basis before its targets are made: they are linear in the frames.
struct BasisPlan {
  std::vector<double> keys;        // as in Basis
  Eigen::MatrixXd weights;         // #keys x #targets
  Eigen::MatrixXd fit;             // #targets x #frames; targets = fit · deltas of the frames from rest
  std::vector<std::string> names;  // #targets
};

/// Plans a basis that plays these shapes (#frames x 3 #vertices, deltas from rest) to a tolerance, file
/// units.
using BasisPlanner = std::function<BasisPlan(const ShapeRows& shapes, double tolerance)>;

/// Plans on a sample of the vertices, makes the targets of all, and adds to the sample those that are played
/// farther than `tolerance` (file units) from where they were solved, until there are none. Vertices that
/// never move by more than a small share of the tolerance get exact zeros.
Basis fitted_basis(const Motion& motion, double tolerance, const BasisPlanner& planner);

}  // namespace flexkey
