#include "flexkey/gltf/walk_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace flexkey {
namespace {

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

/// How far the visits between two frames are from the blend of the two, the largest vertex distance.
double visit_error(const Walk& walk, const ShapeRows& nodes, const ShapeRows& shapes) {
  double largest = 0;
  for (const Visit& visit : walk.visits) {
    if (!visit.is_between_frames()) continue;
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

}  // namespace

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
    if (round > 0 && best.error <= tolerance) break;
    if (round > 0) importance = importance.cwiseProduct(errors / errors.maxCoeff());
    importance = (importance / importance.maxCoeff()).cwiseMax(1e-4);
    now.fit = weighted_fit(now.weights, importance);
  }
  return best;
}

}  // namespace flexkey
