#include "flexkey/gltf/fitted_basis.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>

#include "flexkey/gltf/playback.h"
#include "flexkey/gltf/thin_keys.h"

namespace flexkey {
namespace {

// Shares of the tolerance. What is left is for rounding to floats.
constexpr double kLeastShare = 0.1;   // of plans; below it only rounding is left
constexpr double kStillShare = 0.05;  // a vertex that moves less is at rest
constexpr double kKeyShare = 0.02;    // keys that change less are left out
constexpr double kPlanShare = 0.96;   // what plans may use at first; less where floats take more

/// What floats can tell apart at the motion's coordinates, summed over base, targets and their sum.
double rounding_of(const Motion& motion, double reach) {
  const double farthest = motion.rest.cwiseAbs().maxCoeff() + reach;
  return 4 * static_cast<double>(std::numeric_limits<float>::epsilon()) * farthest;
}

/// A few hundred of the vertices that move, spread over the mesh's order, and the farthest mover.
std::set<int> first_sample(const Eigen::VectorXd& reaches, double still) {
  constexpr std::size_t size = 300;
  std::vector<int> moving;
  for (int vertex = 0; vertex < static_cast<int>(reaches.size()); ++vertex) {
    if (reaches[vertex] > still) moving.push_back(vertex);
  }
  std::set<int> sample;
  for (std::size_t k = 0; k < std::min(size, moving.size()); ++k) {
    sample.insert(moving[k * moving.size() / std::min(size, moving.size())]);
  }
  int farthest = 0;
  reaches.maxCoeff(&farthest);
  sample.insert(farthest);
  return sample;
}

BasisPlan thinned(BasisPlan plan, const ShapeRows& shapes, double allowed) {
  const std::vector<int> kept = kept_keys(plan.keys, plan.weights, plan.fit * shapes, allowed);
  std::vector<double> keys;
  for (const int key : kept) keys.push_back(plan.keys[static_cast<std::size_t>(key)]);
  plan.keys = std::move(keys);
  plan.weights = plan.weights(kept, Eigen::all).eval();
  return plan;
}

/// A basis made of a plan, and the worst vertex of each block that is played beyond the tolerance.
struct Trial {
  Basis basis;
  std::vector<int> beyond;
};

class Fitting {
 public:
  Fitting(const Motion& motion, Eigen::VectorXd reaches, double still)
      : motion_(motion),
        reaches_(std::move(reaches)),
        still_(still),
        blocks_(blocks_of(motion.rest.rows())) {}

  Trial fit(const BasisPlan& plan, double tolerance) const {
    Trial trial{{{}, plan.keys, plan.weights.cast<float>(), plan.names}, {}};
    trial.basis.targets.assign(plan.names.size(), FloatRows(motion_.rest.rows(), 3));
    const Playback playback(motion_, trial.basis.keys, trial.basis.weights);
    std::vector<int> worst(blocks_.size(), -1);
    tbb::parallel_for(std::size_t{0}, blocks_.size(), [&](std::size_t i) {
      const ShapeRows deltas = deltas_of(motion_, blocks_[i]);
      const FloatRows targets = targets_of(plan, deltas, blocks_[i]);
      store(targets, blocks_[i], trial.basis);
      Eigen::Index at = 0;
      const bool is_beyond = playback.errors(blocks_[i], deltas, targets).maxCoeff(&at) > tolerance;
      if (is_beyond) worst[i] = static_cast<int>(blocks_[i].first + at);
    });
    std::copy_if(worst.begin(), worst.end(), std::back_inserter(trial.beyond), [](int v) { return v >= 0; });
    return trial;
  }

 private:
  /// #targets x 3 #block.
  FloatRows targets_of(const BasisPlan& plan, const ShapeRows& deltas, VertexBlock block) const {
    FloatRows targets = (plan.fit * deltas).cast<float>();
    for (Eigen::Index k = 0; k < block.count; ++k) {
      if (reaches_[block.first + k] <= still_) targets.middleCols(3 * k, 3).setZero();
    }
    return targets;
  }

  static void store(const FloatRows& targets, VertexBlock block, Basis& basis) {
    for (Eigen::Index t = 0; t < targets.rows(); ++t) {
      basis.targets[static_cast<std::size_t>(t)].middleRows(block.first, block.count) =
          Eigen::Map<const FloatRows>(targets.row(t).data(), block.count, 3);
    }
  }

  const Motion& motion_;
  Eigen::VectorXd reaches_;
  double still_;
  std::vector<VertexBlock> blocks_;
};

Basis still_basis(const Motion& motion) {
  std::vector<double> keys{static_cast<double>(motion.numbers.front())};
  if (motion.numbers.size() > 1) keys.push_back(motion.numbers.back());
  return {{}, keys, Eigen::MatrixXf(std::ssize(keys), 0), {}};
}

}  // namespace

Basis fitted_basis(const Motion& motion, double tolerance, const BasisPlanner& planner) {
  const Eigen::VectorXd reaches = reaches_of(motion);
  const double rounding = rounding_of(motion, reaches.maxCoeff());
  const double bound = std::max(tolerance, rounding);
  const double still = std::max(kStillShare * bound, rounding / 4);
  if (reaches.maxCoeff() <= still) return still_basis(motion);

  const Fitting fitting(motion, reaches, still);
  std::set<int> sample = first_sample(reaches, still);
  for (double share = kPlanShare;;) {
    const std::vector<int> vertices(sample.begin(), sample.end());
    const ShapeRows shapes = deltas_of(motion, vertices);
    Trial trial = fitting.fit(thinned(planner(shapes, share * bound), shapes, kKeyShare * bound), bound);
    const std::size_t before = sample.size();
    sample.insert(trial.beyond.begin(), trial.beyond.end());
    if (sample.size() == before) share *= 0.8;
    if (trial.beyond.empty() || share < kLeastShare) return std::move(trial.basis);
  }
}

}  // namespace flexkey
