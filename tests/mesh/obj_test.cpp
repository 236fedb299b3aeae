#include "flexkey/mesh/obj.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/read_mesh.h"

namespace flexkey {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Mesh parse(const std::string& text) {
  return parse_obj(text, "x.obj", "").mesh;
}

std::string error_of(const std::string& text) {
  try {
    parse(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Obj, KeepsPolygonsAndVertexOrder) {
  const Mesh mesh = parse(std::string(square) + "v 2 0.5 0\nf 1 2 3 4\nf 2 5 3\nf 1 2 5 3 4\n");
  EXPECT_EQ(mesh.vertex_count(), 5);
  EXPECT_THAT(mesh.face(0), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(mesh.face(1), ElementsAre(1, 4, 2));
  EXPECT_EQ(mesh.face(2).size(), 5u);
}

TEST(Obj, ReadsEveryIndexForm) {
  const std::string uvs = "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n";
  for (const char* face : {"f 1 2 3", "f 1/1 2/2 3/3", "f 1//1 2//1 3//1", "f 1/1/1 2/2/1 3/3/1",
                           "f -4 -3 -2", "f -4/-3/-1 -3/-2/-1 -2/-1/-1"})
    EXPECT_THAT(parse(square + uvs + face).face(0), ElementsAre(0, 1, 2)) << face;
  EXPECT_THAT(parse(square + uvs + "f -4/-3 -3/-2 -2/-1").corner_texcoord, ElementsAre(0, 1, 2));
  EXPECT_THAT(parse(square + uvs + "f 1/3 2//1 3").corner_texcoord, ElementsAre(2, -1, -1));
}

TEST(Obj, NegativeIndicesCountFromWhereTheFaceStands) {
  const Mesh mesh = parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf -3 -2 -1\n");
  EXPECT_THAT(mesh.face(1), ElementsAre(3, 4, 5));
}

TEST(Obj, CoordinatesAreReadToTheLastBit) {
  const Mesh mesh = parse("v 0.1 -1e-3 +2.5\nv 1.0000000000000002 0 0 1.0\nv 0 1 0 0.5 0.5 0.5\nf 1 2 3");
  EXPECT_EQ(mesh.positions(0, 0), 0.1);
  EXPECT_EQ(mesh.positions(0, 2), 2.5);
  EXPECT_EQ(mesh.positions(1, 0), 1.0000000000000002);
}

TEST(Obj, GroupsObjectsAndMaterials) {
  const Mesh mesh =
      parse(std::string(square) +
            "o body\nf 1 2 3\ng nose tip\nusemtl red paint\nf 1 3 4\ng nose\nusemtl\nf 1 2 4\ng empty\n");
  ASSERT_EQ(mesh.groups.size(), 3u);
  EXPECT_EQ(mesh.groups[0].name, "body");
  EXPECT_THAT(mesh.groups[0].faces, ElementsAre(0, 1, 2));
  EXPECT_EQ(mesh.groups[1].name, "nose");
  EXPECT_THAT(mesh.groups[1].faces, ElementsAre(1, 2));
  EXPECT_THAT(mesh.groups[2].faces, ElementsAre(1));
  EXPECT_EQ(mesh.materials[0].name, "red paint");
  EXPECT_THAT(mesh.face_material, ElementsAre(-1, 0, -1));
}

TEST(Obj, CommentsCarriageReturnsAndContinuedLines) {
  const Mesh mesh = parse("# a square\r\nv 0 0 0 # first\r\nv 1 0 \\\r\n 0\r\nv 0 1 0\r\n\r\nf 1 2 \\\n3");
  EXPECT_EQ(mesh.positions(1, 0), 1);
  EXPECT_THAT(mesh.face(0), ElementsAre(0, 1, 2));
}

TEST(Obj, NamesThePlaceOfABadNumber) {
  EXPECT_EQ(error_of("v 0 0 0\nv nan 0 0\n"),
            "x.obj:2: vertex 1 has the coordinate 'nan', which is not a finite number");
  EXPECT_THAT(error_of("v 0 0 inf\n"), HasSubstr("'inf', which is not a finite number"));
  EXPECT_THAT(error_of("v 0 0 1e999\n"), HasSubstr("'1e999'"));
  EXPECT_THAT(error_of("v 0 0\n"), HasSubstr("x.obj:1: vertex 0 has too few coordinates"));
}

TEST(Obj, SkipsAByteOrderMark) {
  EXPECT_EQ(parse("\xEF\xBB\xBFv 7 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").positions(0, 0), 7);
}

TEST(Obj, RefusesCoordinatesThatCannotBeSquared) {
  EXPECT_EQ(error_of("v 1e31 0 0\n"), "x.obj:1: vertex 0 has the coordinate '1e31', beyond ±1e30");
}

TEST(Obj, NamesThePlaceOfABadIndex) {
  EXPECT_EQ(error_of(std::string(square) + "f 1 2 5"),
            "x.obj:5: face 0 uses vertex index 5, but there are 4 so far");
  EXPECT_THAT(error_of(std::string(square) + "f 0 1 2"), HasSubstr("vertex index 0"));
  EXPECT_THAT(error_of(std::string(square) + "f -5 1 2"), HasSubstr("vertex index -5"));
  EXPECT_THAT(error_of(std::string(square) + "f 1/1 2 3"),
              HasSubstr("texture coordinate index 1, but there are 0"));
  EXPECT_THAT(error_of(std::string(square) + "f 1 2"), HasSubstr("face 0 has 2 corners"));
  EXPECT_THAT(error_of(std::string(square) + "f 1 2 x"), HasSubstr("'x' is not vertex index"));
  EXPECT_THAT(error_of(std::string(square) + "f 1 2 99999999999999999999"), HasSubstr("is not vertex index"));
}

TEST(Obj, AFileWithoutFacesIsNoMesh) {
  EXPECT_EQ(error_of(square), "x.obj: no faces in it");
  EXPECT_EQ(error_of(""), "x.obj: no faces in it");
}

TEST(Obj, WhatIsPassedOverIsSaid) {
  const MeshFile file =
      parse_obj(std::string(square) + "f 1 2 3\nl 1 2\nl 2 3\nmtllib none.mtl\n", "x.obj", "/nowhere");
  ASSERT_EQ(file.warnings.size(), 2u);
  EXPECT_EQ(file.warnings[0], "x.obj:8: no material library 'none.mtl'; its materials are grey");
  EXPECT_EQ(file.warnings[1], "x.obj: 2 elements 'l' are passed over");
}

TEST(Obj, ReadsItsMaterialLibrary) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "obj_with_materials";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "my paints.mtl") << "newmtl skin\nKd 0.8 0.5 0.4\nd 0.5\nmap_Kd -s 1 1 1 skin.png\n";
  std::ofstream(folder / "x.OBJ") << "mtllib my paints.mtl\n" << square << "usemtl skin\nf 1 2 3\n";
  const MeshFile file = read_mesh(folder / "x.OBJ");
  ASSERT_EQ(file.mesh.materials.size(), 1u);
  EXPECT_NEAR(file.mesh.materials[0].base_color.x(), 0.8, 1e-6);
  EXPECT_NEAR(file.mesh.materials[0].opacity, 0.5, 1e-6);
  EXPECT_EQ(file.mesh.materials[0].texture, "skin.png");
  EXPECT_TRUE(file.warnings.empty());
  EXPECT_THAT(file.inputs, ElementsAre(folder / "my paints.mtl"));
  std::filesystem::remove_all(folder);
}

TEST(ReadMesh, AnotherFormatIsNamed) {
  try {
    read_mesh("x.fbx");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(
        error.what(),
        HasSubstr("cannot read 'x.fbx': meshes are read from .obj, .ply, .off, .stl, .glb and .gltf files"));
  }
}

}  // namespace
}  // namespace flexkey
