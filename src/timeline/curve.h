#pragma once

#include <array>
#include <vector>

#include "flexkey/timeline/track.h"

namespace flexkey {

/// Shares of arc length, 0..1, of the vertices of a chain, #n x 3. A chain without length is shared out
/// evenly.
Eigen::VectorXd arc_shares(const Positions& chain);

/// A cubic Bézier piece by its four control points.
using Cubic = std::array<Vec3, 4>;

/// The curve as cubic pieces, straight ones for polylines. Uniform Catmull-Rom has the end points 2 p0 − p1
/// reflected. chain: what `rest` stands for, #n x 3.
std::vector<Cubic> cubics_of(const Curve& curve, const Positions& chain);

/// A curve with its arc length measured once, within 1e-9 of it.
class MeasuredCurve {
 public:
  MeasuredCurve(const Curve& curve, const Positions& chain);

  double length() const { return length_; }
  /// The point at a share (0..1) of the arc length; the curve's own end points at 0 and 1. A curve without
  /// length is one point.
  Vec3 at(double share) const;

 private:
  /// A stretch of a cubic short enough for one quadrature.
  struct Leaf {
    std::size_t cubic = 0;
    double from = 0, to = 1;       // of the cubic's parameter
    double start = 0, length = 0;  // of the whole curve's arc
  };
  void add_leaves(std::size_t cubic, double from, double to, int depth);

  Vec3 first_ = Vec3::Zero(), last_ = Vec3::Zero();
  std::vector<Cubic> cubics_;
  std::vector<Leaf> leaves_;
  double length_ = 0;
};

}  // namespace flexkey
