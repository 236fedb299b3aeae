#include "flexkey/deform/fixed_point.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "flexkey/deform/right_hand_side.h"
#include "flexkey/deform/tail.h"

namespace flexkey {
namespace {

/// Steps this much smaller than the tolerance are its rounding noise, whose tail cannot be judged.
constexpr double still = 1e-6;

/// The global step: new positions for F, with the frame's targets and the last R_i and S_i.
Positions free_step(const Problem& problem, const Iterate& at, const Eigen::VectorXd& lambda) {
  const Positions r = right_hand_side(problem.patch, at.transforms, lambda);
  return problem.system.step(problem.patch, r, at.positions);
}

}  // namespace

FixedPoint iterate(const Problem& problem, Iterate from, const Eigen::VectorXd& lambda, int solves) {
  const auto& [options, patch, system, diagonal] = problem;
  FixedPoint result{std::move(from), {}};
  Iterate& at = result.at;
  SolveReport& report = result.report;
  report.converged = patch.free == 0 && !options.fixed_count;  // nothing to solve
  if (patch.free == 0) return result;
  GeometricTail tail;
  while (report.solves < solves && !report.converged) {
    const Positions step = free_step(problem, at, lambda);
    ++report.solves;
    report.step = step.rowwise().norm().maxCoeff() / diagonal;
    if (!step.allFinite() || !std::isfinite(report.step)) {
      throw DeformError(fmt::format("the solve left the range of numbers at iteration {}", report.solves));
    }
    at.positions.topRows(patch.free) += step;
    at.transforms = local_step(patch, at.positions, at.transforms, options);
    const double left = tail.after(report.step);
    const bool settled = left <= options.tolerance || report.step <= still * options.tolerance;
    report.converged = settled && !options.fixed_count;
  }
  return result;
}

}  // namespace flexkey
