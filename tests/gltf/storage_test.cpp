// How the arrays lie in the file: bounds, sparse accessors, buffer views, index width.
#include <gtest/gtest.h>

#include "flexkey/gltf/write_glb.h"
#include "gltf/clips.h"
#include "gltf/glb_file.h"

namespace flexkey::testing {
namespace {

tinygltf::Model written(const Clip& clip, const GltfOptions& options = exact()) {
  const TemporaryFolder folder;
  write_glb(clip, options, folder / "shot.glb");
  return load_glb(folder / "shot.glb");
}

const tinygltf::Accessor& accessor(const tinygltf::Model& model, int index) {
  return model.accessors.at(static_cast<std::size_t>(index));
}

void expect_exact_bounds(const tinygltf::Model& model, int index) {
  const Eigen::MatrixXd rows = rows_of(model, index);
  for (Eigen::Index column = 0; column < rows.cols(); ++column) {
    EXPECT_EQ(accessor(model, index).minValues.at(static_cast<std::size_t>(column)),
              rows.col(column).minCoeff());
    EXPECT_EQ(accessor(model, index).maxValues.at(static_cast<std::size_t>(column)),
              rows.col(column).maxCoeff());
  }
}

TEST(Storage, PositionsHaveExactBounds) {
  const tinygltf::Model model = written(clip_of(sheet(6), 5, bump));
  const tinygltf::Primitive& primitive = model.meshes[0].primitives[0];
  expect_exact_bounds(model, primitive.attributes.at("POSITION"));
  ASSERT_EQ(primitive.targets.size(), 5u);
  for (const auto& target : primitive.targets) expect_exact_bounds(model, target.at("POSITION"));
}

TEST(Storage, ATargetThatMovesAFewVerticesIsSparseAndSmaller) {
  const tinygltf::Model model = written(clip_of(sheet(10), 3, bump));
  const int moved = model.meshes[0].primitives[0].targets[2].at("POSITION");
  ASSERT_TRUE(accessor(model, moved).sparse.isSparse);
  EXPECT_EQ(accessor(model, moved).bufferView, -1);
  EXPECT_EQ(accessor(model, moved).sparse.count, 9);  // x and y of 0, 0.1 and 0.2
  EXPECT_LT(stored_bytes(model, moved), 121u * 12u);
}

TEST(Storage, ATargetThatMovesEverythingIsDense) {
  const tinygltf::Model model =
      written(clip_of(cube(), 3, [](const Vec3& p, int k) { return Vec3(p + k * Vec3(0.3, 0.2, 0.1)); }));
  const int moved = model.meshes[0].primitives[0].targets[1].at("POSITION");
  EXPECT_FALSE(accessor(model, moved).sparse.isSparse);
  EXPECT_EQ(stored_bytes(model, moved), 8u * 12u);
}

TEST(Storage, NoAccessorIsLargerThanItsOtherFormWouldBe) {
  const tinygltf::Model model = written(clip_of(sheet(20), 20, bump));
  for (std::size_t i = 0; i < model.accessors.size(); ++i) {
    const tinygltf::Accessor& one = model.accessors[i];
    if (one.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) continue;
    const Eigen::MatrixXd rows = rows_of(model, static_cast<int>(i));
    const auto dense = static_cast<std::size_t>(rows.size()) * 4;
    EXPECT_LE(stored_bytes(model, static_cast<int>(i)), dense);
    if (one.sparse.isSparse) {
      EXPECT_LT(stored_bytes(model, static_cast<int>(i)), dense);
    }
  }
}

TEST(Storage, TargetsOfAStillClipAreOneElementSparse) {
  const tinygltf::Model model = written(clip_of(sheet(4), 6, stay));
  for (const auto& target : model.meshes[0].primitives[0].targets) {
    ASSERT_EQ(target.size(), 2u);
    for (const auto& [attribute, index] : target) {
      ASSERT_TRUE(accessor(model, index).sparse.isSparse) << attribute;
      EXPECT_EQ(accessor(model, index).sparse.count, 1);
      EXPECT_TRUE(rows_of(model, index).isZero(0));
    }
    EXPECT_EQ(accessor(model, target.at("POSITION")).minValues, std::vector<double>(3, 0.0));
    EXPECT_EQ(accessor(model, target.at("POSITION")).maxValues, std::vector<double>(3, 0.0));
  }
}

TEST(Storage, WeightsGrowWithTheFramesAndNotWithTheirSquare) {
  const tinygltf::Model model = written(clip_of(cube(), 150, twist));
  const int weights = model.animations[0].samplers[0].output;
  EXPECT_EQ(accessor(model, weights).count, 150u * 150u);
  EXPECT_LE(stored_bytes(model, weights), 150u * 8u);
  const Eigen::MatrixXd rows = rows_of(model, weights);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) EXPECT_EQ(rows(i, 0), i % 151 == 0 ? 1.0 : 0.0);
}

TEST(Storage, ViewsAreAlignedAndHaveTheirTargets) {
  const tinygltf::Model model = written(clip_of(sheet(7), 4, bump));
  for (const tinygltf::BufferView& view : model.bufferViews) {
    EXPECT_EQ(view.byteOffset % 4, 0u);
    EXPECT_EQ(view.byteStride, 0u);
  }
  const tinygltf::Primitive& primitive = model.meshes[0].primitives[0];
  const auto target = [&](int index) {
    return model.bufferViews[static_cast<std::size_t>(accessor(model, index).bufferView)].target;
  };
  EXPECT_EQ(target(primitive.attributes.at("POSITION")), TINYGLTF_TARGET_ARRAY_BUFFER);
  EXPECT_EQ(target(primitive.indices), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  EXPECT_EQ(target(model.animations[0].samplers[0].input), 0);
}

/// Triangles that share no vertex.
Mesh scattered_triangles(int count) {
  Mesh mesh;
  mesh.positions.resize(count * 3, 3);
  for (int v = 0; v < count * 3; ++v) mesh.positions.row(v) << v / 3 + (v % 3 == 1), v % 3 == 2, 0;
  for (int t = 0; t < count; ++t) mesh.add_face(std::array{3 * t, 3 * t + 1, 3 * t + 2});
  return mesh;
}

int index_type(const Mesh& mesh) {
  GltfOptions plain = exact();
  plain.normals = false;
  const tinygltf::Model model = written(clip_of(mesh, 1, stay), plain);
  return accessor(model, model.meshes[0].primitives[0].indices).componentType;
}

TEST(Storage, IndicesAreNarrowWhereTheyNeedNot65535) {
  Mesh mesh = scattered_triangles(21'845);  // 65,535 vertices, the last of which is 65534
  EXPECT_EQ(index_type(mesh), TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT);
  mesh.positions.conservativeResize(65'536, 3);
  mesh.positions.row(65'535) << 0, 0, 1;
  mesh.add_face(std::array{0, 1, 65'535});
  EXPECT_EQ(index_type(mesh), TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
}

TEST(Storage, VerticesOfNoFaceAreNotWritten) {
  Mesh mesh = cube();
  mesh.positions.conservativeResize(10, 3);
  mesh.positions.bottomRows(2).setConstant(77);
  const tinygltf::Model model = written(clip_of(mesh, 2, twist));
  const int positions = model.meshes[0].primitives[0].attributes.at("POSITION");
  EXPECT_EQ(accessor(model, positions).count, 8u);
  EXPECT_LT(rows_of(model, positions).maxCoeff(), 2);
}

}  // namespace
}  // namespace flexkey::testing
