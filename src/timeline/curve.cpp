#include "flexkey/timeline/curve.h"

#include <algorithm>
#include <cmath>

namespace flexkey {
namespace {

Vec3 point_on(const Cubic& c, double u) {
  const double v = 1 - u;
  return v * v * v * c[0] + 3 * v * v * u * c[1] + 3 * v * u * u * c[2] + u * u * u * c[3];
}

double speed_on(const Cubic& c, double u) {
  const double v = 1 - u;
  return 3 * (v * v * (c[1] - c[0]) + 2 * v * u * (c[2] - c[1]) + u * u * (c[3] - c[2])).norm();
}

/// ∫ speed over [from, to] by five-point Gauss-Legendre quadrature.
double quadrature(const Cubic& cubic, double from, double to) {
  constexpr std::array<double, 3> nodes = {0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 3> weights = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  double sum = weights[0] * speed_on(cubic, middle);
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    sum +=
        weights[k] * (speed_on(cubic, middle - half * nodes[k]) + speed_on(cubic, middle + half * nodes[k]));
  }
  return half * sum;
}

double control_length(const Cubic& c) {
  return (c[1] - c[0]).norm() + (c[2] - c[1]).norm() + (c[3] - c[2]).norm();
}

Cubic straight(const Vec3& a, const Vec3& b) {
  return {a, a + (b - a) / 3, b - (b - a) / 3, b};
}

/// The parameter at which the arc from `from` has the wanted length: Newton's method, halving where it leaves
/// the bracket.
double parameter_at(const Cubic& cubic, double from, double to, double wanted) {
  double low = from, high = to, u = 0.5 * (from + to);
  for (int step = 0; step < 60 && high - low > 1e-15; ++step) {
    const double excess = quadrature(cubic, from, u) - wanted;
    if (excess == 0) break;
    (excess > 0 ? high : low) = u;
    const double next = u - excess / speed_on(cubic, u);
    u = next > low && next < high ? next : 0.5 * (low + high);
  }
  return u;
}

std::vector<Vec3> points_of(const Curve& curve, const Positions& chain) {
  if (curve.kind != Curve::Kind::rest) return curve.points;
  std::vector<Vec3> points;
  for (Eigen::Index i = 0; i < chain.rows(); ++i) points.push_back(chain.row(i).transpose());
  return points;
}

}  // namespace

Eigen::VectorXd arc_shares(const Positions& chain) {
  const Eigen::Index n = chain.rows();
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 1; i < n; ++i) shares[i] = shares[i - 1] + (chain.row(i) - chain.row(i - 1)).norm();
  if (n < 2) return shares;
  if (shares[n - 1] > 0) return shares / shares[n - 1];
  return Eigen::VectorXd::LinSpaced(n, 0, 1);
}

std::vector<Cubic> cubics_of(const Curve& curve, const Positions& chain) {
  const std::vector<Vec3> p = points_of(curve, chain);
  std::vector<Cubic> cubics;
  if (curve.kind == Curve::Kind::bezier) {
    for (std::size_t i = 0; i + 3 < p.size(); i += 3) cubics.push_back({p[i], p[i + 1], p[i + 2], p[i + 3]});
    return cubics;
  }
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    if (curve.kind != Curve::Kind::catmull_rom) {
      cubics.push_back(straight(p[i], p[i + 1]));
      continue;
    }
    const Vec3 before = i > 0 ? p[i - 1] : 2 * p[i] - p[i + 1];
    const Vec3 after = i + 2 < p.size() ? p[i + 2] : 2 * p[i + 1] - p[i];
    cubics.push_back({p[i], p[i] + (p[i + 1] - before) / 6, p[i + 1] - (after - p[i]) / 6, p[i + 1]});
  }
  return cubics;
}

MeasuredCurve::MeasuredCurve(const Curve& curve, const Positions& chain) : cubics_(cubics_of(curve, chain)) {
  const std::vector<Vec3> points = points_of(curve, chain);
  if (points.empty()) return;
  first_ = points.front();
  last_ = points.back();
  for (std::size_t i = 0; i < cubics_.size(); ++i) add_leaves(i, 0, 1, 0);
}

void MeasuredCurve::add_leaves(std::size_t cubic, double from, double to, int depth) {
  constexpr int deepest = 24;  // a cusp halves its way down to here
  const Cubic& c = cubics_[cubic];
  const double middle = 0.5 * (from + to);
  const double whole = quadrature(c, from, to);
  const double halves = quadrature(c, from, middle) + quadrature(c, middle, to);
  if (std::abs(whole - halves) <= 1e-11 * control_length(c) || depth == deepest) {
    leaves_.push_back({cubic, from, to, length_, whole});
    length_ += whole;
    return;
  }
  add_leaves(cubic, from, middle, depth + 1);
  add_leaves(cubic, middle, to, depth + 1);
}

Vec3 MeasuredCurve::at(double share) const {
  if (share <= 0 || length_ == 0) return first_;
  if (share >= 1) return last_;
  const double wanted = share * length_;
  const auto after = std::upper_bound(leaves_.begin(), leaves_.end(), wanted,
                                      [](double length, const Leaf& leaf) { return length < leaf.start; });
  const Leaf& leaf = *std::prev(after);
  const Cubic& cubic = cubics_[leaf.cubic];
  return point_on(cubic, parameter_at(cubic, leaf.from, leaf.to, wanted - leaf.start));
}

}  // namespace flexkey
