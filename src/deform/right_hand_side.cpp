#include "flexkey/deform/right_hand_side.h"

#include <tbb/parallel_for.h>

namespace flexkey {

Positions right_hand_side(const Patch& patch, const Transforms& transforms, const Eigen::VectorXd& lambda) {
  const std::vector<Eigen::Matrix3d>& R = transforms.rotations;
  Positions r(patch.rows, 3);
  tbb::parallel_for(0, patch.rows, [&](int i) {
    const auto S_i = transforms.scales.row(i).transpose().asDiagonal();
    Vec3 delta = Vec3::Zero();
    Vec3 rigid = Vec3::Zero();
    for (const auto [j, weight] : patch.cells.of(i)) {
      const Vec3 e = patch.rest.row(i) - patch.rest.row(j);
      delta += weight * e;
      rigid += weight / 2 * ((R[i] + R[j]) * e);
    }
    const Vec3 smooth = S_i * (R[i] * delta);
    r.row(i) = lambda(i) * rigid + (1 - lambda(i)) * smooth;
  });
  return r;
}

}  // namespace flexkey
