#include "flexkey/timeline/easing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace flexkey {
namespace {

Easing bezier(double x1, double y1, double x2, double y2) {
  return {Easing::Kind::bezier, x1, y1, x2, y2};
}

/// The curve's point at parameter u, by de Casteljau's scheme.
Eigen::Vector2d casteljau(const Easing& e, double u) {
  const Eigen::Vector2d p0(0, 0), p1(e.x1, e.y1), p2(e.x2, e.y2), p3(1, 1);
  const Eigen::Vector2d a = p0 + u * (p1 - p0), b = p1 + u * (p2 - p1), c = p2 + u * (p3 - p2);
  const Eigen::Vector2d d = a + u * (b - a), f = b + u * (c - b);
  return d + u * (f - d);
}

TEST(CubicBezier, LiesOnItsCurve) {
  const Easing curves[] = {bezier(0.25, 0.1, 0.25, 1), bezier(0.42, 0, 0.58, 1), bezier(0, 0, 1, 1),
                           bezier(1, 0, 0, 1),         bezier(0, 1, 0, 1),       bezier(0.3, -0.5, 0.6, 1.7)};
  for (const Easing& curve : curves) {
    for (double u = 0; u <= 1; u += 1.0 / 64) {
      const Eigen::Vector2d point = casteljau(curve, u);
      // Where the curve is vertical in x, y has no bounded slope; the vertical tangent of (1, 0, 0, 1) at u =
      // 1/2.
      const bool vertical = curve.x1 == 1 && std::abs(u - 0.5) < 0.05;
      EXPECT_NEAR(cubic_bezier(curve, point.x()), point.y(), vertical ? 1e-4 : 1e-12);
    }
  }
}

TEST(CubicBezier, ClosedForms) {
  EXPECT_NEAR(cubic_bezier(bezier(1.0 / 3, 1.0 / 3, 2.0 / 3, 2.0 / 3), 0.3), 0.3, 1e-14);
  EXPECT_NEAR(cubic_bezier(bezier(1.0 / 3, 0, 2.0 / 3, 1), 0.25), 0.25 * 0.25 * (3 - 0.5), 1e-14)
      << "smoothstep";
  EXPECT_NEAR(cubic_bezier(bezier(0.42, 0, 0.58, 1), 0.5), 0.5, 1e-14) << "symmetric";
  EXPECT_NEAR(cubic_bezier(bezier(0, 1, 0, 1), 0.125), 0.875, 1e-12) << "x = u^3, y = 1 - (1 - u)^3, u = 1/2";
}

TEST(CubicBezier, MeetsItsEndsAndRises) {
  const Easing ease = bezier(0.25, 0.1, 0.25, 1);
  EXPECT_EQ(cubic_bezier(ease, 0), 0);
  EXPECT_EQ(cubic_bezier(ease, 1), 1);
  double before = 0;
  for (int k = 1; k <= 100; ++k) {
    const double now = cubic_bezier(ease, k / 100.0);
    EXPECT_GT(now, before);
    before = now;
  }
}

TEST(NamedEasings, AreThoseOfCss) {
  const auto find = [](std::string_view name) {
    for (const NamedEasing& named : named_easings()) {
      if (named.name == name) return named.easing;
    }
    ADD_FAILURE() << "no easing " << name;
    return Easing{};
  };
  const auto expect_bezier = [&](std::string_view name, double x1, double y1, double x2, double y2) {
    const Easing easing = find(name);
    EXPECT_EQ(easing.kind, Easing::Kind::bezier) << name;
    EXPECT_EQ(Eigen::Vector4d(easing.x1, easing.y1, easing.x2, easing.y2), Eigen::Vector4d(x1, y1, x2, y2))
        << name;
  };
  expect_bezier("ease", 0.25, 0.1, 0.25, 1);
  expect_bezier("ease-in", 0.42, 0, 1, 1);
  expect_bezier("ease-out", 0, 0, 0.58, 1);
  expect_bezier("ease-in-out", 0.42, 0, 0.58, 1);
  EXPECT_EQ(find("linear").kind, Easing::Kind::linear);
  EXPECT_EQ(find("hold").kind, Easing::Kind::hold);
  EXPECT_EQ(find("smooth").kind, Easing::Kind::smooth);
}

TEST(Eased, LinearAndHold) {
  EXPECT_EQ(eased({}, 0.25), 0.25);
  Easing hold;
  hold.kind = Easing::Kind::hold;
  EXPECT_EQ(eased(hold, 0.999), 0);
  EXPECT_EQ(eased(hold, 1), 1);
}

}  // namespace
}  // namespace flexkey
