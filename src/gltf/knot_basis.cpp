#include "flexkey/gltf/knot_basis.h"

#include <algorithm>
#include <iterator>

#include "flexkey/gltf/basis.h"
#include "flexkey/gltf/fitted_basis.h"
#include "flexkey/gltf/walk.h"
#include "flexkey/gltf/walk_fit.h"

namespace flexkey {
namespace {

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
               [](const Visit& visit) { return visit.is_between_frames(); });
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
