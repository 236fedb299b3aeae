#include "flexkey/gltf/fit_targets.h"

#include <tbb/parallel_for.h>

#include <Eigen/QR>

namespace flexkey {

std::vector<FloatRows> fit_targets(const Basis& basis, std::span<const int> numbers, const Positions& rest,
                                   const FrameAttribute& attribute) {
  const Eigen::MatrixXd weights = weights_at_frames(basis, numbers);  // #frames x #targets
  std::vector<FloatRows> targets(basis.targets.size(), FloatRows::Zero(rest.rows(), 3));
  if (targets.empty()) return targets;
  const Eigen::MatrixXf fit = weights.completeOrthogonalDecomposition().pseudoInverse().cast<float>();
  const FloatRows base = rest.cast<float>();
  for (std::size_t frame = 0; frame < numbers.size(); ++frame) {
    const FloatRows delta = (attribute(frame) - base.cast<double>()).cast<float>();
    tbb::parallel_for(std::size_t{0}, targets.size(), [&](std::size_t t) {
      targets[t] += fit(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(frame)) * delta;
    });
  }
  return targets;
}

}  // namespace flexkey
