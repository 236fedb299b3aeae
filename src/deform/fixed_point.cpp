#include "flexkey/deform/fixed_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "flexkey/deform/anderson.h"
#include "flexkey/deform/right_hand_side.h"
#include "flexkey/deform/tail.h"

namespace flexkey {
namespace {

/// Steps this much smaller than the tolerance are its rounding noise, whose tail cannot be judged.
constexpr double still = 1e-6;
constexpr int anderson_window = 5;
constexpr double unknown = std::numeric_limits<double>::infinity();

/// One run of the iteration: where it is and what it has spent.
class Iteration {
 public:
  Iteration(const Problem& problem, Iterate from, const Eigen::VectorXd& lambda)
      : problem_(problem), lambda_(lambda), result_{std::move(from), {}} {}

  /// The global step from where the iteration is, free x 3, with the frame's targets and the last R_i and
  /// S_i.
  Positions step();
  /// Moves the vertices of F and fits R_i and S_i there: the local step.
  void move(const Positions& free_positions);
  /// Whether the estimated distance (share of the diagonal) allows to stop after the last step.
  bool settles(double estimate);

  Positions free_positions() const { return result_.at.positions.topRows(problem_.patch.free); }
  const SolveReport& report() const { return result_.report; }
  void remember_stretch(double stretch) { result_.at.stretch = stretch; }
  double stretch() const { return result_.at.stretch; }
  FixedPoint finish() { return std::move(result_); }

 private:
  const Problem& problem_;
  const Eigen::VectorXd& lambda_;
  FixedPoint result_;
};

Positions Iteration::step() {
  SolveReport& report = result_.report;
  const Positions r = right_hand_side(problem_.patch, result_.at.transforms, lambda_);
  Positions step = problem_.system.step(problem_.patch, r, result_.at.positions);
  ++report.solves;
  report.step = step.rowwise().norm().maxCoeff() / problem_.diagonal;
  report.estimate = unknown;
  if (!step.allFinite() || !std::isfinite(report.step)) {
    throw DeformError(fmt::format("the solve left the range of numbers at iteration {}", report.solves));
  }
  return step;
}

void Iteration::move(const Positions& free_positions) {
  Iterate& at = result_.at;
  at.positions.topRows(problem_.patch.free) = free_positions;
  at.transforms = local_step(problem_.patch, at.positions, at.transforms, problem_.options);
}

bool Iteration::settles(double estimate) {
  SolveReport& report = result_.report;
  const double tolerance = problem_.options.tolerance;
  report.estimate = report.step <= still * tolerance ? report.step : estimate;
  report.converged = report.estimate <= tolerance && !problem_.options.fixed_count;
  return report.converged;
}

void iterate_plainly(Iteration& iteration, int solves) {
  GeometricTail tail;
  while (iteration.report().solves < solves) {
    const Positions step = iteration.step();
    iteration.move(iteration.free_positions() + step);
    if (iteration.settles(tail.after(iteration.report().step))) return;
  }
}

void iterate_accelerated(Iteration& iteration, int solves) {
  // The first step leaves predicted rotations for positions that agree with their own: no pair to mix.
  const Positions start = iteration.step();
  iteration.move(iteration.free_positions() + start);
  Anderson anderson(anderson_window);
  while (iteration.report().solves < solves) {
    const Positions x = iteration.free_positions(), f = iteration.step();
    const Positions next = anderson.next(x, f);
    const double measured = anderson.stretch() > 0 ? anderson.stretch() : iteration.stretch();
    if (measured > 0) iteration.remember_stretch(measured);
    const double estimate = measured > 0 ? std::max(1.0, measured) * iteration.report().step : unknown;
    const bool done = iteration.settles(estimate) || iteration.report().solves == solves;
    iteration.move(done ? Positions(x + f) : next);
    if (done) return;
  }
}

}  // namespace

FixedPoint iterate(const Problem& problem, Iterate from, const Eigen::VectorXd& lambda, int solves) {
  if (problem.patch.free == 0) {
    const bool converged = !problem.options.fixed_count;  // nothing to solve
    return {std::move(from), {.converged = converged}};
  }
  Iteration iteration(problem, std::move(from), lambda);
  if (problem.options.accelerate) {
    iterate_accelerated(iteration, solves);
  } else {
    iterate_plainly(iteration, solves);
  }
  return iteration.finish();
}

}  // namespace flexkey
