#include "implicit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flexkey::meshes {

namespace {

constexpr double kFold = 0.012;       // half-width over which the fold at x = 0 is rounded
constexpr double kDerivative = 1e-4;  // step of the numeric derivative

// Polynomial smooth minimum: exact farther than k from the seam, C1 within.
double smooth_min(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - 0.25 * k * h * h;
}

double smooth_max(double a, double b, double k) {
  return -smooth_min(-a, -b, k);
}

double ellipsoid_distance(const Vec3& p, const Vec3& radii) {
  const double k0 = p.cwiseQuotient(radii).norm();
  const double k1 = p.cwiseQuotient(radii.cwiseProduct(radii)).norm();
  if (k1 < 1e-12) return -radii.minCoeff();
  return k0 * (k0 - 1.0) / k1;
}

double round_cone_distance(const Vec3& p, const Vec3& a, double ra, const Vec3& b, double rb) {
  const Vec3 ab = b - a;
  const double length2 = ab.squaredNorm();
  // The foot is shifted along the axis so that the distance is taken square to the slanted side.
  const Vec3 ap = p - a;
  const double y = ap.dot(ab) / length2;
  const double away = (ap - y * ab).norm();
  const double length = std::sqrt(length2);
  const double slope = (ra - rb) / length;
  const double side = std::sqrt(std::max(1.0 - slope * slope, 1e-6));
  const double t = std::clamp(y + away * slope / side / length, 0.0, 1.0);
  return (ap - t * ab).norm() - (ra + t * (rb - ra));
}

// Balls along the Catmull-Rom spline through the given ones, close enough that plain round cones
// between them look smooth.
std::vector<Ball> refined(const std::vector<Ball>& balls) {
  constexpr int kPieces = 5;
  std::vector<Eigen::Vector4d> knots;
  for (const Ball& b : balls) knots.emplace_back(b.centre.x(), b.centre.y(), b.centre.z(), b.radius);
  std::vector<Ball> fine{balls.front()};
  for (Index i = 0; i + 1 < knots.size(); ++i) {
    const Eigen::Vector4d &b = knots[i], &c = knots[i + 1];
    const Eigen::Vector4d a = i > 0 ? knots[i - 1] : Eigen::Vector4d(2.0 * b - c);
    const Eigen::Vector4d d = i + 2 < knots.size() ? knots[i + 2] : Eigen::Vector4d(2.0 * c - b);
    for (int piece = 1; piece <= kPieces; ++piece) {
      const double t = static_cast<double>(piece) / kPieces;
      const Eigen::Vector4d p =
          b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
      fine.push_back({p.head<3>(), p[3]});
    }
  }
  return fine;
}

}  // namespace

Field ellipsoid(const Vec3& centre, const Vec3& radii) {
  return [=](const Vec3& p) { return ellipsoid_distance(p - centre, radii); };
}

Field ellipsoid(const Vec3& centre, const Vec3& radii, const Vec3& degrees) {
  const Vec3 r = degrees * (std::acos(-1.0) / 180.0);
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(r.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(r.y(), Vec3::UnitY()) *
       Eigen::AngleAxisd(r.x(), Vec3::UnitX()))
          .toRotationMatrix();
  const Eigen::Matrix3d back = turn.transpose();
  return [=](const Vec3& p) { return ellipsoid_distance(back * (p - centre), radii); };
}

Field round_cone(const Vec3& a, double ra, const Vec3& b, double rb) {
  return [=](const Vec3& p) { return round_cone_distance(p, a, ra, b, rb); };
}

Field chain(const std::vector<Ball>& balls) {
  const std::vector<Ball> fine = refined(balls);
  return [=](const Vec3& p) {
    double d = 1e9;
    for (Index i = 0; i + 1 < fine.size(); ++i)
      d = std::min(
          d, round_cone_distance(p, fine[i].centre, fine[i].radius, fine[i + 1].centre, fine[i + 1].radius));
    return d;
  };
}

Field squeezed(const Field& field, const Vec3& centre, const Vec3& factors) {
  const double least = factors.minCoeff();
  return [=](const Vec3& p) {
    const Vec3 q = centre + (p - centre).cwiseQuotient(factors);
    return least * field(q);
  };
}

Field half_space(const Vec3& point, const Vec3& normal) {
  const Vec3 n = normal.normalized();
  return [=](const Vec3& p) { return n.dot(p - point); };
}

Clay& Clay::add(Field shape, double k) {
  steps_.push_back({std::move(shape), k, Action::kAdd});
  return *this;
}

Clay& Clay::carve(Field shape, double k) {
  steps_.push_back({std::move(shape), k, Action::kCarve});
  return *this;
}

Clay& Clay::keep(Field shape, double k) {
  steps_.push_back({std::move(shape), k, Action::kKeep});
  return *this;
}

double Clay::value(const Vec3& p) const {
  const Vec3 q(std::sqrt(p.x() * p.x() + kFold * kFold) - kFold, p.y(), p.z());
  double d = 1e3;
  for (const Step& step : steps_) {
    const double s = step.shape(q);
    if (step.action == Action::kAdd) d = smooth_min(d, s, step.k);
    if (step.action == Action::kCarve) d = smooth_max(d, -s, step.k);
    if (step.action == Action::kKeep) d = smooth_max(d, s, step.k);
  }
  return d;
}

Vec3 Clay::gradient(const Vec3& p) const {
  // Differences along the corners of a tetrahedron take four values where the axes take six.
  Vec3 g = Vec3::Zero();
  for (const Vec3& corner : {Vec3(1, -1, -1), Vec3(-1, -1, 1), Vec3(-1, 1, -1), Vec3(1, 1, 1)})
    g += value(p + kDerivative * corner) * corner;
  // The field is even in x: on the middle plane only rounding could tilt the gradient out of it.
  if (p.x() == 0.0) g.x() = 0.0;
  return g / (4.0 * kDerivative);
}

Vec3 Clay::on_surface(const Vec3& p) const {
  Vec3 q = p;
  for (int step = 0; step < 30; ++step) {
    const Vec3 g = gradient(q);
    q -= 0.7 * value(q) * g / std::max(g.squaredNorm(), 0.1);
  }
  return q;
}

Vec3 Clay::cast_back(const Vec3& p) const {
  Vec3 q = p;
  for (int step = 0; step < 400; ++step) {
    const double d = value(q);
    if (d < 1e-5) return q;
    // The field overestimates in places, so steps are cautious.
    q.z() -= std::min(0.6 * d, 0.02) + 1e-6;
  }
  return p;
}

}  // namespace flexkey::meshes
