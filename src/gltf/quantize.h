#pragma once

#include <Eigen/Core>
#include <vector>

#include "flexkey/gltf/targets.h"

namespace flexkey {

/// Targets in integers that stand for −1 … 1, of which a target's scale makes deltas: a weight times its
/// scale plays them, so that the file's nodes need no transform of their own.
struct QuantizedTargets {
  std::vector<ShortRows> positions;      // #targets of #V x 3, a delta is scale · integer / 32767
  std::vector<ShortRows> normals;        // the same over normal_largest; none where float_normals has them
  std::vector<FloatRows> float_normals;  // where integers could not tell them: a delta is scale · float
  int normal_largest = 127;              // 127 or 32767: whether normals take one byte or two
  std::vector<float> scales;             // #targets, positive
  MorphTargets poses;                    // targets behind those, as they are
};

/// How coarse the integers may be.
struct QuantizationBudget {
  double length = 0;    // of the distance that rounding may add to a vertex, file units
  double angle = 0.01;  // of what rounding may turn a normal by, radians
};

/// weights: #frames x #targets. Steps are as large as the budgets allow, since small integers compress well:
/// the errors of the targets, each as large as its largest weight lets it be, add up as independent ones do.
QuantizedTargets quantize(const MorphTargets& targets, const Eigen::MatrixXf& weights,
                          const QuantizationBudget& budget);

}  // namespace flexkey
