#include "flexkey/gltf/fit_targets.h"

#include <tbb/parallel_for.h>

#include <Eigen/QR>

namespace flexkey {

std::vector<FloatRows> fit_targets(const Basis& basis, std::span<const int> numbers, const Positions& rest,
                                   const FrameAttribute& attribute, double still) {
  const Eigen::MatrixXd weights = weights_at_frames(basis, numbers);  // #frames x #targets
  std::vector<FloatRows> targets(basis.targets.size(), FloatRows::Zero(rest.rows(), 3));
  if (targets.empty()) return targets;
  const Eigen::MatrixXf fit = weights.completeOrthogonalDecomposition().pseudoInverse().cast<float>();
  const FloatRows base = rest.cast<float>();
  Eigen::VectorXf farthest = Eigen::VectorXf::Zero(rest.rows());
  for (std::size_t frame = 0; frame < numbers.size(); ++frame) {
    const FloatRows delta = attribute(frame).cast<float>() - base;
    farthest = farthest.cwiseMax(delta.rowwise().norm());
    tbb::parallel_for(std::size_t{0}, targets.size(), [&](std::size_t t) {
      targets[t] += fit(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(frame)) * delta;
    });
  }
  const Eigen::ArrayXf moving = (farthest.array() > static_cast<float>(still)).cast<float>();
  for (FloatRows& target : targets) target.array().colwise() *= moving;
  return targets;
}

}  // namespace flexkey
