#include "flexkey/gltf/knot_basis.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "flexkey/gltf/basis.h"
#include "flexkey/gltf/fitted_basis.h"
#include "flexkey/gltf/walk.h"

namespace flexkey {
namespace {

/// A walk with its nodes moved so that the frames lie near its ways. Node 0, rest, is no target.
struct WalkFit {
  Eigen::MatrixXd weights;  // #frames x #targets
  Eigen::MatrixXd fit;      // #targets x #frames; targets = fit · shapes
  double error = 0;         // largest vertex distance at a frame or a visit
};

/// The visit at or before each frame.
std::vector<std::size_t> last_visits(const Walk& walk, Eigen::Index frames) {
  std::vector<std::size_t> last(static_cast<std::size_t>(frames));
  std::size_t visit = 0;
  for (std::size_t frame = 0; frame < last.size(); ++frame) {
    while (visit + 1 < walk.visits.size() && walk.visits[visit + 1].frame <= static_cast<double>(frame))
      ++visit;
    last[frame] = visit;
  }
  return last;
}

/// Each frame at its nearest place of its way, #frames x #nodes.
Eigen::MatrixXd places_on(const Walk& walk, const ShapeRows& nodes, const ShapeRows& shapes) {
  const std::vector<std::size_t> last = last_visits(walk, shapes.rows());
  Eigen::MatrixXd places = Eigen::MatrixXd::Zero(shapes.rows(), nodes.rows());
  for (Eigen::Index frame = 0; frame < shapes.rows(); ++frame) {
    const std::size_t visit = last[static_cast<std::size_t>(frame)];
    const int from = walk.visits[visit].node;
    if (walk.visits[visit].frame == static_cast<double>(frame)) {
      places(frame, from) = 1;
      continue;
    }
    const int to = walk.visits[visit + 1].towards;
    const double share = share_of_way(shapes.row(frame), nodes.row(from), nodes.row(to));
    places(frame, from) = 1 - share;
    places(frame, to) += share;
  }
  return places;
}

bool is_between_frames(const Visit& visit) {
  return visit.frame != std::floor(visit.frame);
}

/// How far the visits between two frames are from the blend of the two, the largest vertex distance.
double visit_error(const Walk& walk, const ShapeRows& nodes, const ShapeRows& shapes) {
  double largest = 0;
  for (const Visit& visit : walk.visits) {
    if (!is_between_frames(visit)) continue;
    const auto before = static_cast<Eigen::Index>(visit.frame);
    const double share = visit.frame - static_cast<double>(before);
    const ShapeRow solved = (1 - share) * shapes.row(before) + share * shapes.row(before + 1);
    largest = std::max(largest, largest_length(nodes.row(visit.node) - solved));
  }
  return largest;
}

/// Targets of least squares: (Wᵀ Ω W)⁻¹ Wᵀ Ω, #targets x #frames.
Eigen::MatrixXd weighted_fit(const Eigen::MatrixXd& weights, const Eigen::VectorXd& importance) {
  const Eigen::MatrixXd right = weights.transpose() * importance.asDiagonal();
  return (right * weights).llt().solve(right);
}

/// Moves the nodes off their frames by least squares, and then towards the smallest largest error by giving
/// more importance to the frames that are farther off (C. L. Lawson, "Contributions to the theory of linear
/// least maximum approximation", 1961), until within the tolerance.
WalkFit fit_walk(const Walk& walk, const ShapeRows& shapes, double tolerance) {
  constexpr int rounds = 12;
  const auto targets = std::ssize(walk.origin) - 1;
  WalkFit now{{}, Eigen::MatrixXd::Zero(targets, shapes.rows()), 0}, best;
  for (Eigen::Index t = 0; t < targets; ++t) now.fit(t, walk.origin[static_cast<std::size_t>(t) + 1]) = 1;
  Eigen::VectorXd importance = Eigen::VectorXd::Ones(shapes.rows());
  ShapeRows nodes = ShapeRows::Zero(targets + 1, shapes.cols());
  for (int round = 0; round < rounds; ++round) {
    nodes.bottomRows(targets) = now.fit * shapes;
    const Eigen::MatrixXd places = places_on(walk, nodes, shapes);
    const Eigen::VectorXd errors = largest_lengths(shapes - places * nodes);
    now.weights = places.rightCols(targets);
    now.error = std::max(errors.maxCoeff(), visit_error(walk, nodes, shapes));
    if (round == 0 || now.error < best.error) best = now;
    if (best.error <= tolerance) break;
    if (round > 0) importance = importance.cwiseProduct(errors / errors.maxCoeff());
    importance = (importance / importance.maxCoeff()).cwiseMax(1e-4);
    now.fit = weighted_fit(now.weights, importance);
  }
  return best;
}

struct Knots {
  Walk walk;
  WalkFit fit;
};

/// Fewest targets: how far frames may be from the ways between frames' own shapes, so that they are within
/// the tolerance once the nodes have moved. Up to twice as far for a smooth motion, whose curve then lies on
/// both sides of its ways.
Knots find_knots(const ShapeRows& shapes, double tolerance) {
  constexpr int trials = 5;
  Walk first = walk_along(shapes, tolerance);
  Knots best{first, fit_walk(first, shapes, tolerance)};
  double good = 1, bad = 3;
  for (int trial = 0; trial < trials; ++trial) {
    const double reach = (good + bad) / 2;
    Walk walk = walk_along(shapes, reach * tolerance);
    if (walk.origin.size() >= best.walk.origin.size()) {
      good = reach;
      continue;
    }
    WalkFit fit = fit_walk(walk, shapes, tolerance);
    if (fit.error <= tolerance) {
      best = {std::move(walk), std::move(fit)};
      good = reach;
    } else {
      bad = reach;
    }
  }
  return best;
}

/// Keys at all frames and at the visits between them.
BasisPlan plan_of(const Knots& knots, std::span<const int> numbers) {
  BasisPlan plan;
  plan.fit = knots.fit.fit;
  for (std::size_t node = 1; node < knots.walk.origin.size(); ++node) {
    plan.names.push_back(target_name(numbers[static_cast<std::size_t>(knots.walk.origin[node])]));
  }
  std::vector<Visit> visits;
  std::copy_if(knots.walk.visits.begin(), knots.walk.visits.end(), std::back_inserter(visits),
               is_between_frames);
  plan.weights = Eigen::MatrixXd::Zero(std::ssize(numbers) + std::ssize(visits), std::ssize(plan.names));
  auto visit = visits.begin();
  for (std::size_t frame = 0; frame < numbers.size(); ++frame) {
    plan.weights.row(std::ssize(plan.keys)) = knots.fit.weights.row(static_cast<Eigen::Index>(frame));
    plan.keys.push_back(numbers[frame]);
    if (visit == visits.end() || visit->frame > static_cast<double>(frame + 1)) continue;
    const double share = visit->frame - static_cast<double>(frame);
    if (visit->node != kRestNode) plan.weights(std::ssize(plan.keys), visit->node - 1) = 1;
    plan.keys.push_back(numbers[frame] + share * (numbers[frame + 1] - numbers[frame]));
    ++visit;
  }
  return plan;
}

}  // namespace

Basis knot_basis(const Motion& motion, double tolerance) {
  return fitted_basis(motion, tolerance, [&](const ShapeRows& shapes, double allowed) {
    return plan_of(find_knots(shapes, allowed), motion.numbers);
  });
}

}  // namespace flexkey
