#include "flexkey/mesh/stl.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <vector>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

using Point = std::array<float, 3>;
constexpr Point a{0, 0, 0}, b{1, 0, 0}, c{1, 1, 0}, d{0, 1, 0.1F};

std::string text_of(const std::string& name, const std::vector<std::array<Point, 3>>& triangles) {
  std::string text = fmt::format("solid {}\n", name);
  for (const auto& triangle : triangles) {
    text += " facet normal nan 0 1\n  outer loop\n";
    for (const Point& p : triangle) text += fmt::format("   vertex {} {} {}\n", p[0], p[1], p[2]);
    text += "  endloop\n endfacet\n";
  }
  return text + fmt::format("endsolid {}\n", name);
}

template <class Number>
std::string bytes_of(Number number) {
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  return bytes;
}

std::string binary_of(const std::vector<std::array<Point, 3>>& triangles,
                      const std::string& header = "made") {
  std::string bytes = header;
  bytes.resize(80, ' ');
  bytes += bytes_of(static_cast<std::uint32_t>(triangles.size()));
  for (const auto& triangle : triangles) {
    bytes += std::string(12, '\0');
    for (const Point& p : triangle)
      for (const float x : p) bytes += bytes_of(x);
    bytes += std::string(2, '\x7F');
  }
  return bytes;
}

Mesh parse(const std::string& bytes) {
  return parse_stl(bytes, "x.stl").mesh;
}

std::string error_of(const std::string& bytes) {
  try {
    parse(bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// A square in two triangles.
const std::vector<std::array<Point, 3>> square = {{{c, a, b}}, {{d, a, c}}};

TEST(Stl, VerticesAreNumberedAsTheyFirstAppear) {
  for (const std::string& bytes :
       {text_of("", square), binary_of(square), binary_of(square, "solid binary")}) {
    const Mesh mesh = parse(bytes);
    ASSERT_EQ(mesh.vertex_count(), 4);
    EXPECT_THAT(mesh.face(0), ElementsAre(0, 1, 2));
    EXPECT_THAT(mesh.face(1), ElementsAre(3, 1, 0));
    EXPECT_EQ(mesh.positions.row(0), Eigen::RowVector3d(1, 1, 0));
    EXPECT_NEAR(mesh.positions(3, 2), 0.1, 1e-7);
    EXPECT_TRUE(mesh.groups.empty());
  }
}

TEST(Stl, MinusZeroIsZero) {
  EXPECT_EQ(parse(binary_of({{{a, b, c}}, {{Point{-0.0F, 0, -0.0F}, c, d}}})).vertex_count(), 4);
}

TEST(Stl, NamedSolidsAreGroups) {
  const Mesh mesh = parse(text_of("left nose", {square[0]}) + text_of("ear", {square[1]}) +
                          text_of("left nose", {square[1]}) + text_of("", {square[0]}));
  ASSERT_EQ(mesh.groups.size(), 2u);
  EXPECT_EQ(mesh.groups[0].name, "left nose");
  EXPECT_THAT(mesh.groups[0].faces, ElementsAre(0, 2));
  EXPECT_THAT(mesh.groups[1].faces, ElementsAre(1));
  EXPECT_EQ(mesh.face_count(), 4);
}

TEST(Stl, WhatIsNoMeshIsAnErrorWithItsPlace) {
  EXPECT_EQ(error_of(""), "x.stl: at byte 0: the file ends where the header of an STL should stand");
  const std::string whole = binary_of(square);
  EXPECT_EQ(error_of(whole.substr(0, whole.size() - 1)),
            "x.stl: at byte 80: the file is too short for 2 triangles");
  EXPECT_EQ(error_of(std::string(80, ' ') + bytes_of(40'000'000U)),
            "x.stl: at byte 80: the file is too short for 40000000 triangles");
  EXPECT_EQ(error_of(std::string(80, ' ') + bytes_of(0U)), "x.stl: no faces in it");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(error_of(binary_of({{{a, Point{0, nan, 0}, b}}})),
            "x.stl: at byte 112: triangle 0 has the coordinate 'nan', which is not a finite number");
  EXPECT_THAT(error_of(binary_of({{{a, Point{0, 1e31F, 0}, b}}})), HasSubstr("beyond ±1e30"));
  EXPECT_EQ(error_of("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 inf\n"),
            "x.stl:4: triangle 0 has the coordinate 'inf', which is not a finite number");
  EXPECT_EQ(error_of("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n"),
            "x.stl:5: the file ends where triangle 0 should stand");
  EXPECT_EQ(error_of("solid x\nfacet normal 0 0 1\nloop\n"), "x.stl:3: 'loop' stands where 'outer' should");
  EXPECT_EQ(error_of("solid x\nfacets\n"), "x.stl:2: 'facets' stands where 'facet' should");
  EXPECT_THAT(error_of("solid x\n"), StartsWith("x.stl:2: the file ends where"));
  EXPECT_EQ(error_of("solid x\nendsolid\n"), "x.stl: no faces in it");
}

}  // namespace
}  // namespace flexkey
