#include "flexkey/gltf/quantize.h"

#include <algorithm>
#include <cmath>

namespace flexkey {
namespace {

constexpr double kShort = 32767, kByte = 127;

double largest_entry(const FloatRows& rows) {
  return rows.size() > 0 ? rows.cwiseAbs().maxCoeff() : 0;
}

ShortRows rounded(const FloatRows& deltas, double scale, double largest) {
  return (deltas.cast<double>() * (largest / scale)).array().round().cast<std::int16_t>();
}

/// What the scale of one target has to meet.
struct Demands {
  double reach = 0;          // the largest position delta
  double normal_reach = 0;   // the largest normal delta
  double position_most = 0;  // the scale at which 16 bits just meet the budget of positions
  double normal_most = 0;    // the scale at which a step of 1 in −1 … 1 just meets that of normals
};

Demands demands_of(const MorphTargets& targets, std::size_t target, double largest_weight,
                   const QuantizationBudget& budget) {
  // A rounding error of a step is spread evenly over −1/2 … 1/2 of it.
  const double steps = std::sqrt(12.0 / (3.0 * static_cast<double>(targets.positions.size())));
  const double weight = std::max(largest_weight, 1e-30);
  Demands demands;
  demands.reach = largest_entry(targets.positions[target]);
  demands.position_most = kShort * steps * budget.length / weight;
  if (targets.normals.empty()) return demands;
  demands.normal_reach = largest_entry(targets.normals[target]);
  demands.normal_most = steps * budget.angle / weight;
  return demands;
}

/// The largest scale that meets both budgets with normals of this many steps; 0 where none does.
double common_scale(const Demands& demands, double normal_steps) {
  const double least = std::max(demands.reach, demands.normal_reach);
  const double most = std::min(demands.position_most, demands.normal_most * normal_steps);
  return most >= least ? most : 0;
}

double position_scale(const Demands& demands) {
  return std::max({demands.reach, demands.position_most, 1e-30});
}

bool all_meet(const std::vector<Demands>& demands, double normal_steps) {
  return std::all_of(demands.begin(), demands.end(),
                     [&](const Demands& one) { return common_scale(one, normal_steps) > 0; });
}

}  // namespace

QuantizedTargets quantize(const MorphTargets& targets, const Eigen::MatrixXf& weights,
                          const QuantizationBudget& budget) {
  const std::size_t count = targets.positions.size();
  const bool has_normals = !targets.normals.empty();
  std::vector<Demands> demands;
  for (std::size_t t = 0; t < count; ++t) {
    const double weight = weights.col(static_cast<Eigen::Index>(t)).cwiseAbs().maxCoeff();
    demands.push_back(demands_of(targets, t, weight, budget));
  }
  const bool bytes = has_normals && all_meet(demands, kByte);
  const bool shorts = has_normals && !bytes && all_meet(demands, kShort);
  QuantizedTargets quantized;
  quantized.normal_largest = static_cast<int>(bytes ? kByte : kShort);
  for (std::size_t t = 0; t < count; ++t) {
    const double scale =
        bytes || shorts ? common_scale(demands[t], quantized.normal_largest) : position_scale(demands[t]);
    quantized.scales.push_back(static_cast<float>(scale));
    quantized.positions.push_back(rounded(targets.positions[t], quantized.scales.back(), kShort));
    if (bytes || shorts) {
      quantized.normals.push_back(
          rounded(targets.normals[t], quantized.scales.back(), quantized.normal_largest));
    } else if (has_normals) {
      quantized.float_normals.emplace_back(targets.normals[t] / quantized.scales.back());
    }
  }
  return quantized;
}

}  // namespace flexkey
