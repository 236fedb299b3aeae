#include "flexkey/timeline/curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "flexkey/timeline/sampling.h"

namespace flexkey {
namespace {

constexpr double pi = std::numbers::pi;

Positions rows(std::initializer_list<Vec3> points) {
  Positions result(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::Index row = 0;
  for (const Vec3& point : points) result.row(row++) = point.transpose();
  return result;
}

const Positions no_chain(0, 3);

TEST(Polyline, PointsByArcLength) {
  const Curve curve{Curve::Kind::polyline, {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}}};
  const Positions points = points_at(curve, no_chain, Eigen::Vector4d(0, 0.5, 0.75, 1));
  EXPECT_TRUE(points.isApprox(rows({{0, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 1, 0}}), 1e-12));
}

TEST(Bezier, LengthOfAParabola) {
  // y = x² over [0, 1] as a cubic: control points (0,0), (1/3,0), (2/3,1/3), (1,1).
  const Curve curve{Curve::Kind::bezier, {{0, 0, 0}, {1.0 / 3, 0, 0}, {2.0 / 3, 1.0 / 3, 0}, {1, 1, 0}}};
  const double exact = std::sqrt(5.0) / 2 + std::asinh(2.0) / 4;
  EXPECT_NEAR(MeasuredCurve(curve, no_chain).length(), exact, 1e-10);
}

TEST(Bezier, PointsLieOnTheCurveAtTheirShareOfArcLength) {
  const Curve curve{Curve::Kind::bezier, {{0, 0, 0}, {1.0 / 3, 0, 0}, {2.0 / 3, 1.0 / 3, 0}, {1, 1, 0}}};
  const auto arc_to = [](double x) { return x * std::sqrt(1 + 4 * x * x) / 2 + std::asinh(2 * x) / 4; };
  const MeasuredCurve measured(curve, no_chain);
  for (double share = 0.05; share < 1; share += 0.05) {
    const Vec3 p = measured.at(share);
    EXPECT_NEAR(p.y(), p.x() * p.x(), 1e-12);
    EXPECT_NEAR(arc_to(p.x()) / arc_to(1), share, 1e-9);
  }
}

TEST(Bezier, LengthOfACusp) {
  // x = 3u − 6u² + 4u³, y = 3u − 3u²: both slopes vanish at u = 1/2.
  const Curve curve{Curve::Kind::bezier, {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}}};
  const int steps = 200'000;
  double length = 0;
  const auto point = [](double u) { return Vec3(3 * u - 6 * u * u + 4 * u * u * u, 3 * u - 3 * u * u, 0); };
  for (int k = 0; k < steps; ++k) length += (point((k + 1.0) / steps) - point(double(k) / steps)).norm();
  EXPECT_NEAR(MeasuredCurve(curve, no_chain).length(), length, 1e-6 * length);
}

TEST(Bezier, ChainsOfPiecesMeetTheirKnots) {
  const Curve curve{Curve::Kind::bezier,
                    {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}, {0, 1, 3}, {0, 2, 3}, {0, 3, 3}}};
  const MeasuredCurve measured(curve, no_chain);
  EXPECT_NEAR(measured.length(), 6, 1e-10);
  EXPECT_TRUE(measured.at(0.5).isApprox(Vec3(0, 0, 3), 1e-9));
  EXPECT_TRUE(measured.at(0.75).isApprox(Vec3(0, 1.5, 3), 1e-9));
}

TEST(CatmullRom, GoesThroughItsPointsAndIsSmoothThere) {
  const Curve curve{Curve::Kind::catmull_rom, {{0, 0, 0}, {1, 2, 0}, {3, 1, 1}, {4, 0, 0}}};
  const std::vector<Cubic> cubics = cubics_of(curve, no_chain);
  ASSERT_EQ(cubics.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(cubics[i][0], curve.points[i]);
    EXPECT_EQ(cubics[i][3], curve.points[i + 1]);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE((cubics[i][3] - cubics[i][2]).isApprox(cubics[i + 1][1] - cubics[i + 1][0], 1e-14));
  }
}

TEST(CatmullRom, ReflectsItsEndPoints) {
  // With p₋₁ = 2p₀ − p₁ the end tangent is p₁ − p₀, and two points make a straight line at constant speed.
  const Curve curve{Curve::Kind::catmull_rom, {{0, 0, 0}, {3, 0, 0}}};
  const MeasuredCurve measured(curve, no_chain);
  EXPECT_NEAR(measured.length(), 3, 1e-12);
  EXPECT_TRUE(measured.at(0.25).isApprox(Vec3(0.75, 0, 0), 1e-12));
  const std::vector<Cubic> bent =
      cubics_of({Curve::Kind::catmull_rom, {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}}}, no_chain);
  EXPECT_TRUE((3 * (bent[0][1] - bent[0][0])).isApprox(Vec3(3, 0, 0), 1e-14));
}

TEST(CatmullRom, NearsACircle) {
  Curve curve{Curve::Kind::catmull_rom, {}};
  const int n = 200;
  for (int k = 0; k <= n; ++k)
    curve.points.emplace_back(std::cos(2 * pi * k / n), std::sin(2 * pi * k / n), 0);
  const MeasuredCurve measured(curve, no_chain);
  EXPECT_NEAR(measured.length(), 2 * pi, 1e-3);
  EXPECT_NEAR((measured.at(0.5) - Vec3(-1, 0, 0)).norm(), 0, 1e-9);
}

TEST(Curves, SharesOutsideAreTheEnds) {
  const Curve curve{Curve::Kind::catmull_rom, {{0.1, 0.2, 0.3}, {1, 2, 0}, {3, 1, 1}}};
  const MeasuredCurve measured(curve, no_chain);
  EXPECT_EQ(measured.at(0), curve.points.front());
  EXPECT_EQ(measured.at(-1), curve.points.front());
  EXPECT_EQ(measured.at(1), curve.points.back());
  EXPECT_EQ(measured.at(2), curve.points.back());
}

TEST(Curves, WithoutLengthAreOnePoint) {
  const Vec3 point(1, 2, 3);
  for (const Curve::Kind kind : {Curve::Kind::polyline, Curve::Kind::catmull_rom, Curve::Kind::bezier}) {
    const Curve curve{kind, {point, point, point, point}};
    const Positions points = points_at(curve, no_chain, Eigen::Vector3d(0, 0.5, 1));
    for (Eigen::Index i = 0; i < 3; ++i) EXPECT_EQ(Vec3(points.row(i).transpose()), point);
  }
}

TEST(Curves, WithDoubledPointsStayFinite) {
  const Curve curve{Curve::Kind::polyline,
                    {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, 0}}};
  const Positions points = points_at(curve, no_chain, Eigen::VectorXd::LinSpaced(9, 0, 1));
  for (Eigen::Index i = 0; i < 9; ++i) EXPECT_NEAR(points(i, 0), 0.25 * static_cast<double>(i), 1e-12);
}

TEST(ArcShares, AreCumulativeLengths) {
  const Eigen::VectorXd shares = arc_shares(rows({{0, 0, 0}, {1, 0, 0}, {1, 3, 0}}));
  EXPECT_TRUE(shares.isApprox(Eigen::Vector3d(0, 0.25, 1), 1e-15));
}

TEST(ArcShares, OfDegenerateChains) {
  EXPECT_TRUE(arc_shares(rows({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}})).isApprox(Eigen::Vector3d(0, 0.5, 1)));
  EXPECT_EQ(arc_shares(rows({{1, 1, 1}})).size(), 1);
  EXPECT_EQ(arc_shares(rows({{1, 1, 1}}))[0], 0);
  EXPECT_EQ(arc_shares(no_chain).size(), 0);
}

}  // namespace
}  // namespace flexkey
