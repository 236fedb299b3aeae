#include "flexkey/gltf/thin_keys.h"

namespace flexkey {
namespace {

class KeyThinning {
 public:
  KeyThinning(const std::vector<double>& keys, const Eigen::MatrixXd& weights, const ShapeRows& targets,
              double allowed)
      : keys_(keys), active_((weights.array() != 0).matrix()), shapes_(weights * targets), allowed_(allowed) {
    if (weights.cols() > 0) most_active_ = active_.rowwise().count().maxCoeff();
  }

  /// The last key to which a straight line from this one restores all between: found by doubling, then
  /// halving, the step.
  int next(int key) const {
    int good = key + 1, stride = 1;
    while (restores(key, good + stride)) {
      good += stride;
      stride *= 2;
    }
    for (; stride > 0; stride /= 2) {
      if (restores(key, good + stride)) good += stride;
    }
    return good;
  }

 private:
  bool restores(int from, int to) const {
    if (to >= static_cast<int>(keys_.size())) return false;
    if ((active_.row(from) || active_.row(to)).count() > most_active_) return false;
    for (int key = from + 1; key < to; ++key) {
      const double share = (time(key) - time(from)) / (time(to) - time(from));
      const ShapeRow line = (1 - share) * shapes_.row(from) + share * shapes_.row(to);
      if (largest_length(shapes_.row(key) - line) > allowed_) return false;
    }
    return true;
  }

  double time(int key) const { return keys_[static_cast<std::size_t>(key)]; }

  const std::vector<double>& keys_;
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> active_;  // #keys x #targets
  Eigen::Index most_active_ = 0;
  ShapeRows shapes_;  // #keys x 3 #vertices
  double allowed_;
};

}  // namespace

std::vector<int> kept_keys(const std::vector<double>& keys, const Eigen::MatrixXd& weights,
                           const ShapeRows& targets, double allowed) {
  const KeyThinning thinning(keys, weights, targets, allowed);
  std::vector<int> kept{0};
  while (kept.back() + 1 < static_cast<int>(keys.size())) kept.push_back(thinning.next(kept.back()));
  return kept;
}

}  // namespace flexkey
