#include <gtest/gtest.h>

#include <variant>

#include "timeline/parsing.h"

namespace flexkey {
namespace {

Selection parse_selection(const std::string& text) {
  return *parse(with_base("points: {tip: [1, 2, 3]}\npaths: {arc: [[0, 0, 0], tip]}\nroi: " + text + "\n"))
              .roi;
}

template <class Kind>
Kind parse_kind(const std::string& text) {
  return std::get<Kind>(parse_selection(text).kind);
}

TEST(Selection, Vertices) {
  for (const char* text : {"{vertices: [0, 12-40]}", "{vertices: \"0,12-40\"}", "{vertices: '0, 12 - 40'}"}) {
    const auto select = parse_kind<SelectVertices>(text);
    ASSERT_EQ(select.ranges.size(), 2u) << text;
    EXPECT_EQ(select.ranges[0].first, 0);
    EXPECT_EQ(select.ranges[0].last, 0);
    EXPECT_EQ(select.ranges[1].first, 12);
    EXPECT_EQ(select.ranges[1].last, 40);
  }
  EXPECT_EQ(parse_kind<SelectVertices>("{vertices: 7}").ranges.at(0).last, 7);
}

TEST(Selection, Names) {
  EXPECT_EQ(parse_kind<SelectGroup>("{group: leg_hind_l}").name, "leg_hind_l");
  EXPECT_EQ(parse_kind<SelectGroup>("{group: 12}").name, "12");
  EXPECT_EQ(parse_kind<SelectMaterial>("{material: 'red skin'}").name, "red skin");
  EXPECT_EQ(parse_kind<SelectNode>("{node: left eye}").name, "left eye");
}

TEST(Selection, Shapes) {
  const auto sphere = parse_kind<SelectSphere>("{sphere: {center: tip, radius: 5%}}");
  EXPECT_EQ(sphere.center, Vec3(1, 2, 3));
  EXPECT_TRUE(sphere.radius.is_share);
  EXPECT_EQ(sphere.radius.value, 0.05);
  const auto box = parse_kind<SelectBox>("{box: {min: [-1, -1, -1], max: tip}}");
  EXPECT_EQ(box.min, Vec3(-1, -1, -1));
  EXPECT_EQ(box.max, Vec3(1, 2, 3));
  const auto plane = parse_kind<SelectPlane>("{plane: {point: [0, 0, 0], normal: [0, 3, 4], within: 2}}");
  EXPECT_TRUE(plane.normal.isApprox(Vec3(0, 0.6, 0.8), 1e-15));
  EXPECT_FALSE(plane.within.is_share);
  EXPECT_EQ(plane.within.value, 2);
}

TEST(Selection, Axis) {
  const auto band = parse_kind<SelectAxis>("{axis: y, above: -2, below: 50%}");
  EXPECT_EQ(band.axis, 1);
  EXPECT_EQ(band.above->value, -2);
  EXPECT_FALSE(band.above->is_share);
  EXPECT_EQ(band.below->value, 0.5);
}

TEST(Selection, OnTheSurface) {
  EXPECT_EQ(parse_kind<SelectNearest>("{nearest: tip}").point, Vec3(1, 2, 3));
  EXPECT_EQ(parse_kind<SelectGeodesic>("{geodesic: {from: [1, 0, 0], radius: 0.5}}").radius.value, 0.5);
  EXPECT_EQ(parse_kind<SelectPath>("{path: [tip, [0, 0, 0], tip]}").points.size(), 3u);
  EXPECT_EQ(parse_kind<SelectPath>("{path: arc}").points.at(1), Vec3(1, 2, 3))
      << "the points of a named path";
  EXPECT_FALSE(parse_kind<SelectBoundary>("{boundary: longest}").all);
  EXPECT_TRUE(parse_kind<SelectBoundary>("{boundary: all}").all);
  EXPECT_EQ(parse_kind<SelectComponent>("{component: 2}").index, 2);
}

TEST(Selection, Combined) {
  const Selection any =
      parse_selection("{any: [{group: a}, {not: {all: [{group: b}, {axis: x, above: 0}]}}], grow: 3}");
  EXPECT_EQ(any.grow, 3);
  const auto& parts = std::get<SelectAny>(any.kind).of;
  ASSERT_EQ(parts.size(), 2u);
  const auto& inner = std::get<SelectNot>(parts[1].kind).of;
  ASSERT_EQ(inner.size(), 1u);
  EXPECT_EQ(std::get<SelectAll>(inner[0].kind).of.size(), 2u);
}

TEST(Selection, KnowsThePlaceOfItsKindsValue) {
  const Shot shot = parse(with_base("roi: {grow: 2, any: [{group: leg_hind_l}]}\n"));
  EXPECT_EQ(shot.roi->where.column, 21);
  const Selection& group = std::get<SelectAny>(shot.roi->kind).of.at(0);
  EXPECT_EQ(group.where.line, 4);
  EXPECT_EQ(group.where.column, 30);
}

}  // namespace
}  // namespace flexkey
