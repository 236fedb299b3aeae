#include "flexkey/mesh/obj_tags.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/obj.h"
#include "flexkey/mesh/weld.h"

namespace flexkey {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* two_quads =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 5 6 3\n";

MeshFile parse(const std::string& tags) {
  return parse_obj(two_quads + tags, "x.obj", "");
}

std::string error_of(const std::string& tags) {
  try {
    parse(tags);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ObjTags, CreasesAndCornersCountVerticesFromZero) {
  const MeshFile file = parse("t crease 2/1/0 1 2 2.5\nt corner 1/1/0 5 3\n");
  ASSERT_EQ(file.mesh.creases.size(), 1u);
  EXPECT_EQ(file.mesh.creases[0].from, 1);
  EXPECT_EQ(file.mesh.creases[0].to, 2);
  EXPECT_EQ(file.mesh.creases[0].sharpness, 2.5);
  ASSERT_EQ(file.mesh.sharp_vertices.size(), 1u);
  EXPECT_EQ(file.mesh.sharp_vertices[0].vertex, 5);
  EXPECT_EQ(file.mesh.sharp_vertices[0].sharpness, 3);
  EXPECT_THAT(file.warnings, IsEmpty());
}

TEST(ObjTags, OneTagMayHoldSeveral) {
  const Mesh mesh =
      parse("t crease 4/2/0 0 1 1 2 1 inf\nt crease 4/1/0 3 2 4 5 7\nt corner 2/2/0 0 3 1 2\n").mesh;
  std::vector<double> sharpness;
  for (const Crease& crease : mesh.creases) sharpness.push_back(crease.sharpness);
  EXPECT_THAT(sharpness, ElementsAre(1, infinitely_sharp, 7, 7));
  EXPECT_EQ(mesh.sharp_vertices[1].sharpness, 2);
}

TEST(ObjTags, MayStandBeforeWhatTheyName) {
  const MeshFile file = parse_obj(std::string("t crease 2/1/0 0 1 1\n") + two_quads, "x.obj", "");
  EXPECT_EQ(file.mesh.creases.size(), 1u);
}

TEST(ObjTags, WhatIsNoEdgeIsSaidAndLeftOut) {
  const MeshFile file = parse("t crease 4/1/0 0 2 1 2 4\n");
  EXPECT_THAT(file.warnings,
              ElementsAre("x.obj:9: vertices 0 and 2 have no edge to crease (tags count from 0)"));
  ASSERT_EQ(file.mesh.creases.size(), 1u);
  EXPECT_EQ(file.mesh.creases[0].from, 1);
}

TEST(ObjTags, OtherTagsArePassedOver) {
  EXPECT_THAT(parse("t interpolateboundary 1/0/0 2\n").warnings,
              ElementsAre("x.obj: 1 elements 't' are passed over"));
}

TEST(ObjTags, WhatCannotBeIsAnErrorWithItsLine) {
  EXPECT_EQ(error_of("t crease 2/1/0 1 6 2\n"),
            "x.obj:9: there is no vertex 6; tags count them from 0, and there are 6");
  EXPECT_EQ(error_of("t corner 1/1/0 -1 2\n"),
            "x.obj:9: there is no vertex -1; tags count them from 0, and there are 6");
  EXPECT_EQ(error_of("\nt crease 2/1/0 1 2 -1\n"), "x.obj:10: the sharpness '-1' is no number from 0 up");
  EXPECT_EQ(error_of("t crease 2/1/0 1 2 nan\n"), "x.obj:9: the sharpness 'nan' is no number from 0 up");
  EXPECT_EQ(error_of("t crease 2/1/0 1 2\n"), "x.obj:9: a crease says '2/1/0' and has 2 values");
  EXPECT_EQ(error_of("t crease 2/1/0 1 2 3 4\n"), "x.obj:9: a crease says '2/1/0' and has 4 values");
  EXPECT_EQ(error_of("t crease 3/1/0 1 2 3 4\n"), "x.obj:9: a crease has 3 whole numbers, two vertices each");
  EXPECT_EQ(error_of("t crease 2/2/0 1 2 3 4\n"),
            "x.obj:9: 1 creases have 2 numbers; one sharpness of all, or one each, is needed");
  EXPECT_EQ(error_of("t corner 1/1/0 1.5 3\n"), "x.obj:9: '1.5' is no vertex");
  EXPECT_THAT(error_of("t crease\n"), HasSubstr("as in 't crease 2/1/0 7 8 2.5'"));
  EXPECT_THAT(error_of("t crease 2/x/0 1 2 3\n"), HasSubstr("as in 't crease 2/1/0 7 8 2.5'"));
  EXPECT_THAT(error_of("t crease 9223372036854775807/9223372036854775807/0 1\n"), HasSubstr("has 1 values"));
}

TEST(ObjTags, ASeamIsCreasedOnTheWeldedSurface) {
  Mesh mesh = parse("t crease 2/1/0 1 2 4\nt corner 1/1/0 5 2\n").mesh;
  Positions rows(8, 3);  // the common edge has two vertices a place, the second pair first
  rows << 1, 0, 0, 1, 1, 0, mesh.positions;
  mesh.positions = rows;
  for (int& v : mesh.corners) v += 2;
  mesh.corners[4] = 0;
  mesh.corners[7] = 1;
  for (Crease& crease : mesh.creases) crease = {crease.from + 2, crease.to + 2, crease.sharpness};
  mesh.sharp_vertices[0].vertex += 2;
  const Mesh surface = weld(mesh).surface;
  ASSERT_EQ(surface.creases.size(), 1u);
  EXPECT_EQ(surface.positions.row(surface.creases[0].from), mesh.positions.row(3));
  EXPECT_EQ(surface.positions.row(surface.creases[0].to), mesh.positions.row(4));
  EXPECT_EQ(surface.positions.row(surface.sharp_vertices[0].vertex), mesh.positions.row(7));
}

}  // namespace
}  // namespace flexkey
