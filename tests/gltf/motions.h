#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <vector>

#include "flexkey/gltf/basis.h"
#include "support/meshes.h"

namespace flexkey::testing {

/// Frames made in code, and what a basis is fitted to.
struct Frames {
  Positions rest;
  std::vector<Positions> frames;
  std::vector<int> numbers;
  Motion motion() const { return {frames, rest, numbers}; }
};

/// A shape of the rest positions when its motion has gone a share of its way.
using Course = std::function<Positions(const Positions& rest, double share)>;

/// Frame k at shares[k] of a course, on the 90 vertices of a bar; no coordinate is a float.
inline Frames frames_of(const Course& course, const std::vector<double>& shares) {
  Frames result{meshes::bar(2, 2, 10).positions.array() + 0.1, {}, std::vector<int>(shares.size())};
  for (const double share : shares) result.frames.push_back(course(result.rest, share));
  std::iota(result.numbers.begin(), result.numbers.end(), 0);
  return result;
}

/// The bar bent about x, by a quarter turn at its end.
inline Positions bent(const Positions& rest, double share) {
  Positions positions = rest;
  for (Eigen::Index v = 0; v < rest.rows(); ++v) {
    const double angle = share * std::numbers::pi / 2 * (rest(v, 2) - 0.1) / 10;
    positions(v, 1) = std::cos(angle) * rest(v, 1) - std::sin(angle) * rest(v, 2);
    positions(v, 2) = std::sin(angle) * rest(v, 1) + std::cos(angle) * rest(v, 2);
  }
  return positions;
}

/// Every vertex on a straight line.
inline Positions stretched(const Positions& rest, double share) {
  Positions positions = rest;
  positions.col(2) *= 1 + 0.3 * share;
  positions.col(0) += 0.2 * share * rest.col(2);
  return positions;
}

/// The vertices above the middle alone on a circle: a motion of rank 2.
inline Positions circled(const Positions& rest, double share) {
  Positions positions = rest;
  for (Eigen::Index v = 0; v < rest.rows(); ++v) {
    const double size = rest(v, 2) > 5 ? rest(v, 2) - 5 : 0;
    positions(v, 0) += size * std::sin(3 * share);
    positions(v, 1) += size * (std::cos(3 * share) - 1);
  }
  return positions;
}

/// 0 … 1 in `steps` even steps.
inline std::vector<double> evenly(int steps) {
  std::vector<double> shares;
  for (int k = 0; k <= steps; ++k) shares.push_back(static_cast<double>(k) / steps);
  return shares;
}

inline std::vector<double> eased(std::vector<double> shares) {
  for (double& share : shares) share *= share * (3 - 2 * share);
  return shares;
}

inline std::vector<double> reversed(std::vector<double> shares) {
  std::reverse(shares.begin(), shares.end());
  return shares;
}

inline std::vector<double> joined(std::vector<double> a, const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// What a client shows at a time (in frames): weights between two keys, and a sum in floats.
inline Positions shown(const Basis& basis, const Positions& rest, double time) {
  std::size_t key = 0;
  while (key + 2 < basis.keys.size() && basis.keys[key + 1] <= time) ++key;
  const std::size_t next = std::min(key + 1, basis.keys.size() - 1);
  const double length = basis.keys[next] - basis.keys[key];
  const auto share = static_cast<float>(length > 0 ? (time - basis.keys[key]) / length : 0);
  FloatRows sum = rest.cast<float>();
  for (std::size_t t = 0; t < basis.targets.size(); ++t) {
    const auto column = static_cast<Eigen::Index>(t);
    const float weight = (1 - share) * basis.weights(static_cast<Eigen::Index>(key), column) +
                         share * basis.weights(static_cast<Eigen::Index>(next), column);
    sum += weight * basis.targets[t];
  }
  return sum.cast<double>();
}

/// The farthest that a vertex is shown from where it was solved, at every tenth of a frame, between which the
/// solved frames are blended.
inline double farthest_shown(const Basis& basis, const Frames& frames) {
  double largest = 0;
  for (std::size_t k = 0; k < frames.frames.size(); ++k) {
    const std::size_t next = std::min(k + 1, frames.frames.size() - 1);
    for (int tenth = 0; tenth < 10; ++tenth) {
      const double share = 0.1 * tenth;
      const Positions solved = (1 - share) * frames.frames[k] + share * frames.frames[next];
      const double time = frames.numbers[k] + share * (frames.numbers[next] - frames.numbers[k]);
      largest = std::max(largest, (shown(basis, frames.rest, time) - solved).rowwise().norm().maxCoeff());
    }
  }
  return largest;
}

/// What rounding to floats may cost at these coordinates, of up to about 15.
constexpr double kRounding = 1e-5;

}  // namespace flexkey::testing
