#include "flexkey/mesh/off.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

Mesh parse(const std::string& text) {
  return parse_off(text, "x.off").mesh;
}

std::string error_of(const std::string& text) {
  try {
    parse(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Off, KeepsPolygonsAndVertexOrder) {
  const Mesh mesh = parse(std::string("OFF\n# a square and a triangle\n5 2 0\n") + square +
                          "2 0.5 0.1  # the last\n4 0 1 2 3\n3 1 4 2\n");
  EXPECT_EQ(mesh.vertex_count(), 5);
  EXPECT_EQ(mesh.positions(4, 2), 0.1);
  EXPECT_THAT(mesh.face(0), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(mesh.face(1), ElementsAre(1, 4, 2));
}

TEST(Off, PassesOverColoursAndNormals) {
  const Mesh coloured = parse(std::string("OFF 4 1 4\r\n") + square + "4 0 1 2 3 255 0 0\n");
  EXPECT_EQ(coloured.face_count(), 1);
  const Mesh more = parse("COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 0 1 0 1\n0 1 0 0 0 1 1\n3 0 1 2 9\n");
  EXPECT_EQ(more.positions(1, 0), 1);
  EXPECT_EQ(more.positions(2, 1), 1);
}

TEST(Off, WhatIsNoMeshIsAnErrorWithItsLine) {
  const std::string head = "OFF\n4 1 0\n";
  EXPECT_EQ(error_of(""), "x.off:1: the file ends where 'OFF' should stand");
  EXPECT_EQ(error_of("solid\n"), "x.off:1: an OFF file begins with 'OFF'");
  EXPECT_THAT(error_of("4OFF\n1 1 1\n"), HasSubstr("'4OFF' is not one of three dimensions"));
  EXPECT_THAT(error_of("OFF BINARY\n"), HasSubstr("a binary OFF cannot be read"));
  EXPECT_EQ(error_of("OFF\n20000000 1 0\n0 0 0\n"),
            "x.off:2: the file is too short for 20000000 vertices and 1 faces");
  EXPECT_THAT(error_of("OFF\n-1 1 0\n"), HasSubstr("the count of vertices is -1, outside 0.."));
  EXPECT_THAT(error_of("OFF\n99999999999999999999 1 0\n"), HasSubstr("is no whole number"));
  EXPECT_EQ(error_of(head + square + "4 0 1 2 4\n"), "x.off:7: a vertex of face 0 is 4, outside 0..3");
  EXPECT_EQ(error_of(head + square + "2 0 1 2 3\n"),
            "x.off:7: the corner count of face 0 is 2, outside 3..2147483646");
  EXPECT_EQ(error_of(head + square + "2000000 0 1 2 3\n"),
            "x.off:7: the file is too short for the 2000000 corners of face 0");
  EXPECT_EQ(error_of(head + "0 0 0\n1 0 nan\n1 1 0\n0 1 0\n4 0 1 2 3\n"),
            "x.off:4: vertex 1 has the coordinate 'nan', which is not a finite number");
  EXPECT_THAT(error_of("OFF\n4 2 0\n" + std::string(square) + "4 0 1 2 3\n# nothing more, alas\n"),
              HasSubstr("the file ends where the corner count of face 1 should stand"));
  EXPECT_THAT(error_of(head + square + "4 0 1 2 3\n3 0 1 2\n"), HasSubstr("goes on behind its last face"));
  EXPECT_THAT(error_of("OFF\n0 0 0\n"), HasSubstr("no faces in it"));
}

}  // namespace
}  // namespace flexkey
