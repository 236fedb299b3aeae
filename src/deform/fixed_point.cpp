#include "flexkey/deform/fixed_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "flexkey/deform/anderson.h"
#include "flexkey/deform/residual.h"
#include "flexkey/deform/tail.h"

namespace flexkey {
namespace {

/// Steps this much smaller than the tolerance are its rounding noise, whose tail cannot be judged.
constexpr double still = 1e-6;
constexpr int anderson_window = 5;
constexpr double fading = 0.98;  // of κ, a frame
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
  double diagonal() const { return problem_.diagonal; }
  FixedPoint finish() { return std::move(result_); }

 private:
  const Problem& problem_;
  const Eigen::VectorXd& lambda_;
  FixedPoint result_;
  Residuals residuals_;
};

Positions Iteration::step() {
  SolveReport& report = result_.report;
  residual(problem_.cells, result_.at.positions, result_.at.transforms, lambda_, residuals_.rows);
  Positions step = problem_.system.step(problem_.cells, residuals_);
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
  local_step(problem_.cells, problem_.options, at.positions, at.transforms);
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

/// How far the fixed point may be, as a share of the diagonal: κ times the step, and no less than the way
/// that the mixture of the last steps would take at once, which sees slow modes that a single step hides.
double estimated_distance(const Iteration& iteration, const Positions& plain, const Positions& mixed) {
  if (iteration.stretch() == 0) return unknown;
  const double jump = (mixed - plain).rowwise().norm().maxCoeff() / iteration.diagonal();
  return std::max(std::max(1.0, iteration.stretch()) * iteration.report().step, jump);
}

void iterate_accelerated(Iteration& iteration, int solves) {
  // The first step leaves predicted rotations for positions that agree with their own: no pair to mix.
  const Positions start = iteration.step();
  iteration.move(iteration.free_positions() + start);
  // A frame that stops at its first look measures no κ, so what earlier frames measured fades slowly.
  iteration.remember_stretch(fading * iteration.stretch());
  Anderson anderson(anderson_window);
  while (iteration.report().solves < solves) {
    const Positions x = iteration.free_positions(), f = iteration.step(), plain = x + f;
    const Positions mixed = anderson.next(x, f);
    iteration.remember_stretch(std::max(anderson.stretch(), iteration.stretch()));
    const bool settled = iteration.settles(estimated_distance(iteration, plain, mixed));
    const bool done = settled || iteration.report().solves == solves;
    iteration.move(done ? plain : mixed);
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
