#include "flexkey/gltf/reduction.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "flexkey/gltf/fit_targets.h"
#include "flexkey/gltf/float_grid.h"
#include "flexkey/gltf/knot_basis.h"
#include "flexkey/gltf/motion.h"
#include "flexkey/gltf/pca_basis.h"
#include "flexkey/gltf/pose_targets.h"
#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

// Normals that never turn by a tenth of a degree stay as they are at rest.
constexpr double kStillNormal = 0.0017;
constexpr double kNormalStep = 1.0 / 4096;  // to which normals of poses are rounded where all is packed
constexpr double kStillShare = 0.05;  // of the tolerance; a vertex that a pose moves by less stays at rest

/// How much of the tolerance the basis may spend, and how much the integers do, as a distance that they add
/// on average: their largest is about three times that.
struct Budget {
  double basis = 1;
  double integers = 0;
};

Budget budget_of(const GltfOptions& options, double strictness) {
  if (options.encoding == Encoding::floats) return {1, 0};
  return {0.8 * strictness, 0.06 * strictness};
}

Basis basis_of(const Motion& motion, const GltfOptions& options, double tolerance) {
  switch (options.basis) {
    case BasisKind::knots:
      return knot_basis(motion, tolerance);
    case BasisKind::pca: {
      Basis basis = pca_basis(motion, tolerance);
      return options.encoding == Encoding::floats ? with_weights_in_unit_range(basis) : basis;
    }
    case BasisKind::frames:
      break;
  }
  return frame_basis(motion);
}

std::vector<int> numbers_of(const Clip& clip) {
  std::vector<int> numbers;
  for (const FrameReport& report : clip.reports) numbers.push_back(report.frame);
  return numbers;
}

std::vector<FloatRows> normal_targets(const Clip& clip, const Basis& basis, const NormalsAt& normals,
                                      Steps& steps) {
  const auto normals_of = [&](std::size_t frame) {
    steps.advance();
    return normals(clip.frames[frame]);
  };
  return fit_targets(basis, numbers_of(clip), normals(clip.mesh.positions), normals_of, kStillNormal);
}

void require_allowed(const Basis& basis, const GltfOptions& options) {
  const std::size_t targets = basis.targets.size() + options.poses.size();
  if (targets <= static_cast<std::size_t>(options.max_targets)) return;
  throw InputError(
      fmt::format("the clip takes {} morph targets as '{}', and at most {} are allowed (max_targets); most "
                  "viewers stop at 256. A larger tolerance, or the profile 'compat' or 'web', takes fewer",
                  targets, profile_name(options), options.max_targets));
}

void append(MorphTargets& targets, MorphTargets poses) {
  std::move(poses.positions.begin(), poses.positions.end(), std::back_inserter(targets.positions));
  std::move(poses.normals.begin(), poses.normals.end(), std::back_inserter(targets.normals));
}

std::vector<FloatRows> last_of(std::vector<FloatRows>& rows, std::size_t count) {
  if (rows.empty()) return {};
  const auto first = rows.end() - static_cast<std::ptrdiff_t>(count);
  std::vector<FloatRows> taken(std::make_move_iterator(first), std::make_move_iterator(rows.end()));
  rows.erase(first, rows.end());
  return taken;
}

/// glTF animates no weights of a mesh without targets.
void require_one_target(Basis& basis, Eigen::Index vertex_count) {
  if (!basis.targets.empty()) return;
  basis.targets.emplace_back(FloatRows::Zero(vertex_count, 3));
  basis.names.emplace_back("still");
  basis.weights = Eigen::MatrixXf::Zero(static_cast<Eigen::Index>(basis.keys.size()), 1);
}

}  // namespace

Reduction reduce(const Clip& clip, const ReductionPlan& plan, const GltfOptions& options, Steps& steps) {
  const double tolerance = options.tolerance * bounds_of(clip.mesh.positions).diagonal();
  const Budget budget = budget_of(options, plan.strictness);
  const std::vector<int> numbers = numbers_of(clip);
  Reduction result;
  result.basis = basis_of({clip.frames, clip.mesh.positions, numbers}, options, budget.basis * tolerance);
  require_allowed(result.basis, options);
  if (options.poses.empty() || options.encoding == Encoding::meshopt)
    require_one_target(result.basis, clip.mesh.positions.rows());
  if (plan.normals) result.targets.normals = normal_targets(clip, result.basis, plan.normals, steps);
  result.targets.positions = std::exchange(result.basis.targets, {});
  result.rounding = budget.integers * tolerance;
  result.poses = options.poses.size();
  append_poses(result.basis, options.poses);
  const double still = options.basis == BasisKind::frames ? 0 : kStillShare * tolerance;
  append(result.targets, pose_targets(clip, options.poses, plan.normals, {still, kStillNormal}));
  return result;
}

QuantizedTargets quantize_targets(Reduction& reduction, double length) {
  MorphTargets& targets = reduction.targets;
  MorphTargets poses{last_of(targets.positions, reduction.poses), last_of(targets.normals, reduction.poses)};
  const auto count = static_cast<Eigen::Index>(targets.positions.size());
  auto weights = reduction.basis.weights.leftCols(count);
  QuantizedTargets quantized = quantize(targets, weights, {.length = length});
  const Eigen::Map<const Eigen::RowVectorXf> scales(quantized.scales.data(), count);
  weights.array().rowwise() *= scales.array();
  for (FloatRows& rows : poses.positions)
    if (length > 0) rows = on_grid(rows, power_of_two_below(length));
  for (FloatRows& rows : poses.normals) rows = on_grid(rows, kNormalStep);
  quantized.poses = std::move(poses);
  return quantized;
}

}  // namespace flexkey
