#include "flexkey/gltf/triangulate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <set>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

using Triangle = std::array<int, 3>;
using Outline = std::vector<std::array<double, 2>>;

/// The outline in a plane that faces no axis.
Positions tilted(const Outline& outline) {
  const Vec3 u = Vec3(1, 2, -1).normalized();
  const Vec3 v = Vec3(3, -1, 1).normalized();
  Positions corners(static_cast<Eigen::Index>(outline.size()), 3);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    corners.row(static_cast<Eigen::Index>(i)) =
        (Vec3(5, 6, 7) + outline[i][0] * u + outline[i][1] * v).transpose();
  }
  return corners;
}

Vec3 area(const Positions& corners, const Triangle& t) {
  const Vec3 a = corners.row(t[0]), b = corners.row(t[1]), c = corners.row(t[2]);
  return 0.5 * (b - a).cross(c - a);
}

Vec3 polygon_area(const Positions& corners) {
  Vec3 sum = Vec3::Zero();
  for (int i = 1; i + 1 < corners.rows(); ++i) sum += area(corners, {0, i, i + 1});
  return sum;
}

/// No triangle is turned over, and together they are as large as the polygon: they cover it once.
void expect_cover(const Outline& outline) {
  const Positions corners = tilted(outline);
  const std::vector<Triangle> triangles = triangulate(corners);
  ASSERT_EQ(triangles.size(), outline.size() - 2);
  const Vec3 whole = polygon_area(corners);
  double sum = 0;
  for (const Triangle& t : triangles) {
    const double share = area(corners, t).dot(whole) / whole.squaredNorm();
    EXPECT_GE(share, -1e-12);
    sum += area(corners, t).norm();
  }
  EXPECT_NEAR(sum, whole.norm(), 1e-9 * whole.norm());
}

Outline star(int tips, double inner) {
  Outline outline;
  for (int i = 0; i < 2 * tips; ++i) {
    const double angle = std::numbers::pi * i / tips, radius = i % 2 == 0 ? 1.0 : inner;
    outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return outline;
}

bool cuts(const std::vector<Triangle>& triangles, int a, int b) {
  return std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return std::set<int>(t.begin(), t.end()).contains(a) && std::set<int>(t.begin(), t.end()).contains(b);
  });
}

TEST(Triangulate, CutsAQuadAlongItsShorterDiagonal) {
  EXPECT_TRUE(cuts(triangulate(tilted({{0, 0}, {2, 0}, {3, 1}, {0, 1}})), 1, 3));
  EXPECT_TRUE(cuts(triangulate(tilted({{0, 1}, {0, 0}, {2, 0}, {3, 1}})), 0, 2));
}

TEST(Triangulate, DoesNotFoldAConcaveQuad) {
  const Outline arrow = {{0, 0}, {5, -1}, {0.5, 0}, {5, 1}};  // the longer diagonal, 1 to 3, lies outside
  expect_cover(arrow);
  const Outline dart = {{0, 0}, {1, -0.2}, {0.9, 0}, {1, 0.2}};  // the shorter one does
  EXPECT_TRUE(cuts(triangulate(tilted(dart)), 0, 2));
  expect_cover(dart);
}

TEST(Triangulate, CoversConvexPolygonsOnce) {
  for (const int corners : {5, 6, 17, 300}) {
    Outline circle;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      circle.push_back({std::cos(angle), std::sin(angle)});
    }
    expect_cover(circle);
  }
}

TEST(Triangulate, CoversConcavePolygonsOnce) {
  expect_cover({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});  // L
  expect_cover(star(5, 0.3));
  expect_cover(star(150, 0.1));
  Outline comb = {{0, -1}};
  for (int i = 0; i < 100; ++i) {
    comb.push_back({i + 0.5, -1});
    comb.push_back({i + 0.75, 5});
  }
  comb.push_back({100, -1});
  comb.push_back({100, -2});
  comb.push_back({0, -2});
  std::reverse(comb.begin(), comb.end());
  expect_cover(comb);
  Outline spiral;
  for (int i = 0; i <= 60; ++i) spiral.push_back({(1 + i) * std::cos(0.3 * i), (1 + i) * std::sin(0.3 * i)});
  for (int i = 60; i >= 0; --i) spiral.push_back({(2 + i) * std::cos(0.3 * i), (2 + i) * std::sin(0.3 * i)});
  std::reverse(spiral.begin(), spiral.end());
  expect_cover(spiral);
}

TEST(Triangulate, CoversPolygonsWithCornersInARow) {
  expect_cover({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
}

TEST(Triangulate, CoversAKeyhole) {  // a square with a square hole, joined by a bridge that is walked twice
  expect_cover({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}});
}

TEST(Triangulate, EndsOnPolygonsWithoutASense) {
  const Outline pentagram = {{0, 1}, {0.6, -0.8}, {-0.95, 0.3}, {0.95, 0.3}, {-0.6, -0.8}};
  EXPECT_EQ(triangulate(tilted(pentagram)).size(), 3u);
  EXPECT_EQ(triangulate(tilted(Outline(6, {1, 1}))).size(), 4u);                        // a point
  EXPECT_EQ(triangulate(tilted({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}})).size(), 3u);  // a line
  EXPECT_EQ(triangulate(tilted({{0, 0}, {1, 1}, {1, 0}, {0, 1}})).size(), 2u);          // a bow tie
  EXPECT_EQ(triangulate(tilted({{0, 0}, {2, 2}, {2, 0}, {0, 2}, {-1, 1.5}, {-1, 0.5}})).size(),
            4u);  // crossing
}

TEST(Triangulate, TakesLargePolygonsOnlyWhereAFanCoversThem) {
  Outline circle;
  for (int i = 0; i < 50'000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 50'000;
    circle.push_back({std::cos(angle), std::sin(angle)});
  }
  EXPECT_EQ(triangulate(tilted(circle)).size(), 49'998u);
  try {
    triangulate(tilted(star(25'000, 0.5)));
    FAIL() << "a star of 50,000 corners was cut";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "a face of 50000 corners is not convex; glTF holds triangles, so split it in the mesh");
  }
}

}  // namespace
}  // namespace flexkey
