#include "flexkey/deform/fixed_point.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "flexkey/deform/residual.h"
#include "flexkey/deform/tail.h"

namespace flexkey {
namespace {

/// Steps this much smaller than the tolerance are its rounding noise, whose tail cannot be judged.
constexpr double still = 1e-6;
/// κ to reckon with at the least, as one or two looks seldom show a window the slowest direction: that of a
/// contraction by 0.98 λ, and this one for small λ.
constexpr double slow = 0.98;
constexpr double least_stretch = 4;
/// Of what is learned of κ, as much as counts: frames that must meet more of it mostly run into their cap.
constexpr double most_learned_stretch = 40;
/// What a further look leaves of what earlier frames were off.
constexpr double unpaid = 0.6;
/// From this frame on those numbered by a power of two fill the window, as κ shows only in many looks: seldom
/// enough to be cheap.
constexpr int first_survey = 16;
constexpr double unknown = std::numeric_limits<double>::infinity();

bool surveys(int frame) {
  return frame >= first_survey && std::has_single_bit(static_cast<unsigned>(frame));
}

double greatest(const Eigen::VectorXd& lambda) {
  return lambda.size() > 0 ? lambda.maxCoeff() : 0;
}

/// One run of the iteration: where it is and what it has spent.
class Iteration {
 public:
  Iteration(const Problem& problem, Iterate from)
      : problem_(problem),
        result_{std::move(from), {}},
        least_stretch_(std::max(least_stretch, 1 / (1 - slow * greatest(result_.at.lambda)))),
        carried_(result_.at.frame < first_survey ? result_.at.unseen : 0) {
    result_.at.window.turn_to_next_map();
  }

  /// What the global step is solved from, free x 3; the room for it comes back through `take`.
  Positions reduced();
  /// Takes the solved step, free x 3.
  void take(Positions step);
  const Transforms& transforms() const { return result_.at.transforms; }
  bool is_done() const { return done_; }
  FixedPoint finish() { return std::move(result_); }

 private:
  void measure();
  void move(const Positions& by);
  void go(const Positions& to);
  double estimated_distance(const Mixture& mixed);
  bool surveys_on() const;
  bool settles(double estimate);

  const Problem& problem_;
  FixedPoint result_;
  double least_stretch_;
  Positions rows_, step_, start_;
  Positions were_;  // the vertices of rigid regions before they were placed
  GeometricTail tail_;
  double carried_;  // of Iterate::unseen as it came
  bool done_ = false;
};

Positions Iteration::reduced() {
  Iterate& at = result_.at;
  were_ = place(problem_.ties.rigid, at.transforms, at.positions);
  residual(problem_.cells, at.positions, at.transforms, at.lambda, rows_);
  problem_.system.reduce(problem_.cells, rows_, step_);
  const Springs& springs = problem_.system.springs();
  if (!springs.vertices.empty()) pull(springs, at.soft - at.positions(springs.vertices, Eigen::all), step_);
  return std::move(step_);
}

void Iteration::measure() {
  SolveReport& report = result_.report;
  ++report.solves;
  report.step = std::sqrt(step_.rowwise().squaredNorm().maxCoeff()) / problem_.diagonal;
  report.estimate = unknown;
  if (!std::isfinite(step_.sum()) || !std::isfinite(report.step))
    throw DeformError(fmt::format("the solve left the range of numbers at iteration {}", report.solves));
}

void Iteration::take(Positions step) {
  step_ = std::move(step);
  take_back(problem_.ties.rigid, were_, result_.at.positions, step_);
  measure();
  const bool is_last = result_.report.solves >= result_.at.most_solves;
  if (!problem_.options.accelerate) {
    move(step_);
    done_ = settles(tail_.after(result_.report.step)) || is_last;
  } else if (result_.report.solves == 1) {
    // The first step leaves predicted rotations for positions that agree with their own: no pair to mix.
    move(step_);
    done_ = is_last;
  } else {
    start_ = result_.at.positions.topRows(problem_.patch.free);
    const Mixture& mixed = result_.at.window.next(start_, step_);
    done_ = (settles(estimated_distance(mixed)) && !surveys_on()) || is_last;
    if (done_) {
      move(step_);
    } else {
      go(mixed.positions);
    }
  }
}

void Iteration::move(const Positions& by) {
  result_.at.positions.topRows(problem_.patch.free) += by;
  refit(problem_, result_.at);
}

void Iteration::go(const Positions& to) {
  result_.at.positions.topRows(problem_.patch.free) = to;
  refit(problem_, result_.at);
}

/// As a share of the diagonal. A frame of one or two looks hardly moves along the slowest directions, so that
/// what is wrong in them goes on to the next frame. Until a survey has shown how slow they are, estimates add
/// up, and further looks pay them off.
double Iteration::estimated_distance(const Mixture& mixed) {
  Iterate& at = result_.at;
  if (at.window.differences() == 0) return unknown;
  const auto distance = [&](double stretch) {
    return (mixed.jump + stretch * mixed.left) / problem_.diagonal;
  };
  if (result_.report.solves > 2) carried_ *= unpaid;
  at.unseen = carried_ + distance(least_stretch_);
  return std::max(at.unseen, distance(std::min(at.window.stretch(), most_learned_stretch)));
}

/// Whether a look shows more of κ, though the frame has settled. Rounding noise shows nothing.
bool Iteration::surveys_on() const {
  const bool is_still = result_.report.step <= still * problem_.options.tolerance;
  return surveys(result_.at.frame) && !result_.at.window.is_full() && !is_still;
}

bool Iteration::settles(double estimate) {
  SolveReport& report = result_.report;
  const double tolerance = problem_.options.tolerance;
  report.estimate = report.step <= still * tolerance ? report.step : estimate;
  report.converged = report.estimate <= tolerance && !problem_.options.fixed_count;
  return report.converged;
}

}  // namespace

void refit(const Problem& problem, Iterate& at) {
  const std::vector<RigidRegion>& regions = problem.ties.rigid;
  std::vector<Eigen::Matrix3d> last;
  for (const RigidRegion& region : regions) last.push_back(rotation_of(region, at.transforms));
  local_step(problem.cells, problem.options, at.positions, at.transforms);
  turn_as_one(regions, problem.cells, at.positions, last, at.transforms);
}

std::vector<FixedPoint> iterate(const Problem& problem, std::vector<Iterate> from) {
  std::vector<Iteration> iterations;
  for (Iterate& start : from) iterations.emplace_back(problem, std::move(start));
  Factor::Workspace workspace;
  std::vector<Positions> steps;
  std::vector<const Transforms*> transforms;
  std::vector<Iteration*> running;
  for (Iteration& iteration : iterations)
    if (problem.patch.free > 0) running.push_back(&iteration);
  while (!running.empty()) {
    steps.resize(running.size());
    transforms.resize(running.size());
    tbb::parallel_for(std::size_t{0}, running.size(), [&](std::size_t k) {
      steps[k] = running[k]->reduced();
      transforms[k] = &running[k]->transforms();
    });
    problem.system.solve_in_place(steps, transforms, workspace);
    tbb::parallel_for(std::size_t{0}, running.size(),
                      [&](std::size_t k) { running[k]->take(std::move(steps[k])); });
    std::erase_if(running, [](const Iteration* iteration) { return iteration->is_done(); });
  }
  std::vector<FixedPoint> found;
  for (Iteration& iteration : iterations) {
    found.push_back(iteration.finish());
    if (problem.patch.free == 0) found.back().report.converged = !problem.options.fixed_count;
  }
  return found;
}

}  // namespace flexkey
