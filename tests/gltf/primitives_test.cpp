#include "flexkey/gltf/primitives.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "flexkey/mesh/error.h"
#include "gltf/clips.h"

namespace flexkey::testing {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Primitives, CornersShareVerticesWhereNothingParts) {
  const std::vector<Primitive> primitives = split_primitives(cube());
  ASSERT_EQ(primitives.size(), 1u);
  EXPECT_EQ(primitives[0].vertices.size(), 8u);
  EXPECT_EQ(primitives[0].triangles.size(), 36u);
  EXPECT_THAT(primitives[0].texcoords, IsEmpty());
  EXPECT_EQ(primitives[0].material, -1);
}

TEST(Primitives, TextureCoordinatesPartCorners) {
  Mesh mesh = cube();
  mesh.texcoords.resize(24, 2);
  for (int i = 0; i < 24; ++i) {
    mesh.texcoords.row(i) << i, 0;
    mesh.corner_texcoord.push_back(i);
  }
  EXPECT_EQ(split_primitives(mesh)[0].vertices.size(), 24u);
}

TEST(Primitives, EqualTextureCoordinatesAreOne) {
  Mesh mesh = cube();
  mesh.texcoords = TexCoords::Constant(24, 2, 0.25);
  for (int i = 0; i < 24; ++i) mesh.corner_texcoord.push_back(i);
  EXPECT_EQ(split_primitives(mesh)[0].vertices.size(), 8u);
}

TEST(Primitives, TextureCoordinatesAreTurnedOver) {
  Mesh mesh = sheet(1);
  mesh.texcoords.resize(2, 2);
  mesh.texcoords << 0.25, 0.9, 1, 0;
  mesh.corner_texcoord = {0, 1, -1, 1};
  const Primitive primitive = split_primitives(mesh)[0];
  const FloatRows texcoords = texcoords_of(mesh, primitive);
  ASSERT_EQ(texcoords.rows(), 4);
  for (std::size_t row = 0; row < 4; ++row) {
    const auto uv = texcoords.row(static_cast<Eigen::Index>(row));
    const int texcoord = primitive.texcoords[row];
    if (texcoord == 0) {
      EXPECT_EQ(uv, Eigen::RowVector2f(0.25F, 0.1F));
    }
    if (texcoord == 1) {
      EXPECT_EQ(uv, Eigen::RowVector2f(1, 1));
    }
    if (texcoord == -1) {
      EXPECT_EQ(uv, Eigen::RowVector2f(0, 0));
    }
  }
}

TEST(Primitives, FollowTheMaterialsAndFacesWithoutOneComeLast) {
  Mesh mesh = cube();
  mesh.materials = {material("a"), material("unused"), material("c")};
  mesh.face_material = {-1, 2, 0, 2, -1, 0};
  const std::vector<Primitive> primitives = split_primitives(mesh);
  ASSERT_EQ(primitives.size(), 3u);
  EXPECT_EQ(primitives[0].material, 0);
  EXPECT_THAT(primitives[0].faces, ElementsAre(2, 2, 5, 5));
  EXPECT_EQ(primitives[1].material, 2);
  EXPECT_THAT(primitives[1].faces, ElementsAre(1, 1, 3, 3));
  EXPECT_EQ(primitives[2].material, -1);
  EXPECT_THAT(primitives[2].faces, ElementsAre(0, 0, 4, 4));
}

TEST(Primitives, OnlyTrianglesThatRepeatAVertexAreDropped) {
  Mesh mesh;
  mesh.positions.resize(6, 3);
  mesh.positions << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 3, 0, 0;
  mesh.add_face(std::array{0, 1, 1});        // an edge
  mesh.add_face(std::array{0, 1, 1, 2, 0});  // a triangle
  mesh.add_face(std::array{1, 4, 5});        // flat, but of three vertices
  EXPECT_THAT(split_primitives(mesh)[0].faces, ElementsAre(1, 2));
}

TEST(Primitives, KeepTheWindingOfEveryFace) {
  const Mesh mesh = cube();
  const Primitive primitive = split_primitives(mesh)[0];
  const Vec3 middle = mesh.positions.colwise().mean().transpose();
  for (std::size_t t = 0; t < primitive.triangles.size(); t += 3) {
    const auto corner = [&](std::size_t i) -> Vec3 {
      return mesh.positions.row(primitive.vertices[primitive.triangles[t + i]]).transpose();
    };
    EXPECT_GT((corner(1) - corner(0)).cross(corner(2) - corner(0)).dot(corner(0) - middle), 0);
  }
}

TEST(Primitives, AMeshWithoutATriangleIsRefused) {
  Mesh mesh = cube();
  mesh.face_offsets.clear();
  mesh.corners.clear();
  mesh.add_face(std::array{0, 1, 0});
  EXPECT_THROW(split_primitives(mesh), InputError);
}

}  // namespace
}  // namespace flexkey::testing
