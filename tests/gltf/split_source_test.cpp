// Faces that never move as a mesh of their own, in the file that the mesh came from.
#include "flexkey/gltf/split_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "flexkey/gltf/read_accessor.h"
#include "flexkey/gltf/write_glb.h"
#include "flexkey/mesh/read_file.h"
#include "gltf/clips.h"
#include "gltf/expect_split.h"
#include "gltf/validate.h"
#include "support/gltf_builder.h"

namespace flexkey::testing {
namespace {

using json = nlohmann::json;
using meshes::add_tube;
using meshes::GltfBuilder;
using meshes::skinned_tube;
using meshes::Tube;
using meshes::tube_file;
using meshes::tube_with_targets;
using meshes::two_tubes;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr int frames = 5;

/// Bends the tube above its fifth ring, whose normals turn with it.
Vec3 bend_the_end(const Vec3& p, int frame) {
  const double above = std::max(0.0, p.z() - 4);
  return p + 0.05 * frame * above * above * Vec3(1, 0.5, 0);
}

/// What a test changes of the writing.
struct Wish {
  std::vector<std::string> nodes = {};
  std::function<void(GltfOptions&)> options = [](GltfOptions&) {};
  flexkey::testing::Motion motion = bend_the_end;
};

/// The file with some frames in it, split and whole.
class SplitSource : public ::testing::Test {
 protected:
  GltfReport write(const GltfBuilder& builder, const Wish& wish = {}) {
    const GltfFile file = read_gltf(builder.save(folder_ / "in.glb"), wish.nodes);
    Clip clip = clip_of(file.file.mesh, frames, wish.motion);
    clip.name = "bend";
    GltfOptions options = exact();
    options.source = &file.source;
    wish.options(options);
    write_glb(clip, options, whole());
    options.split = true;
    GltfReport report = write_glb(clip, options, split());
    document_ = read_gltf(split()).source.document;
    root_ = json::parse(document_.json);
    return report;
  }

  std::filesystem::path whole() const { return folder_ / "whole.glb"; }
  std::filesystem::path split() const { return folder_ / "split.glb"; }

  const json& primitive(std::size_t mesh, std::size_t p = 0) const {
    return root_["meshes"][mesh]["primitives"][p];
  }
  std::size_t count_of(const json& primitive, const char* attribute = "POSITION") const {
    return root_["accessors"][primitive["attributes"][attribute].get<std::size_t>()]["count"];
  }

  TemporaryFolder folder_;
  Glb document_;  // of the split file
  json root_;
};

TEST_F(SplitSource, TheSolvedNodeShowsTheFacesThatMove) {
  GltfBuilder file = tube_file();
  file.root["meshes"][0]["extras"] = {{"mine", 1}};
  const GltfReport report = write(file);
  expect_same_but_split(split(), whole(), frames, 1e-7);
  EXPECT_EQ(root_["nodes"][0], json({{"name", "tube"}, {"mesh", 0}, {"children", {1}}}));
  EXPECT_EQ(root_["nodes"][1], json({{"name", "tube_still"}, {"mesh", 1}}));
  EXPECT_EQ(root_["scenes"], file.root["scenes"]);
  EXPECT_EQ(root_["meshes"][1]["name"], "tube mesh_still");
  EXPECT_EQ(root_["meshes"][1]["extras"], file.root["meshes"][0]["extras"]);
  EXPECT_FALSE(root_["meshes"][1].contains("weights"));
  EXPECT_FALSE(primitive(1).contains("targets"));
  EXPECT_EQ(primitive(1)["attributes"], file.root["meshes"][0]["primitives"][0]["attributes"]);
  EXPECT_EQ(primitive(1)["material"], 0);
  EXPECT_EQ(count_of(primitive(0)), 9u * 4u) << "rings 3 to 6 of which 3 stays";
  EXPECT_EQ(primitive(0)["targets"].size(), static_cast<std::size_t>(frames));
  EXPECT_EQ(report.target_vertices, 36);
  EXPECT_EQ(report.vertices, 63);
  EXPECT_EQ(report.gpu_bytes, 32u * 36u * static_cast<unsigned>(frames));
  EXPECT_LT(report.error, 1e-6);
  const std::size_t triangles = file.root["meshes"][0]["primitives"][0]["indices"];
  for (const char* list : {"accessors", "bufferViews", "materials"})
    for (std::size_t i = 0; i < file.root[list].size(); ++i)
      EXPECT_EQ(root_[list][i] == file.root[list][i], std::string(list) == "materials" || i != triangles)
          << list << i << ": the file's triangles, which are none any longer, give their place away";
}

TEST_F(SplitSource, PlaysTheSameInEveryProfile) {
  for (const auto& [basis, encoding] :
       {std::pair(BasisKind::knots, Encoding::floats), std::pair(BasisKind::pca, Encoding::meshopt),
        std::pair(BasisKind::pca, Encoding::floats)}) {
    const Wish wish{.options = [&](GltfOptions& options) {
      options.basis = basis;
      options.encoding = encoding;
    }};
    for (const GltfBuilder& file : {tube_file(), skinned_tube()}) {
      const GltfReport report = write(file, wish);
      EXPECT_LE(report.error, 1e-3);
      EXPECT_EQ(report.splits.at(0).why_whole, "");
      expect_same_but_split(split(), whole(), frames, 1e-7);
    }
  }
}

TEST_F(SplitSource, EveryAttributeIsCopiedByteForByte) {
  GltfBuilder file = skinned_tube();
  const auto count = static_cast<std::size_t>(Tube().vertex_count());
  std::vector<std::uint8_t> colors;
  std::vector<std::int16_t> custom;
  for (std::size_t v = 0; v < count; ++v) {
    for (const std::size_t part : {v, 2 * v, 3 * v, 255 - v})
      colors.push_back(static_cast<std::uint8_t>(part));
    custom.push_back(static_cast<std::int16_t>(1000 - 20 * static_cast<int>(v)));
    custom.push_back(7);
  }
  json& attributes = file.root["meshes"][0]["primitives"][0]["attributes"];
  attributes["COLOR_0"] = file.add_accessor(colors, 4, {{"normalized", true}});
  attributes["_PAIR"] = file.add_accessor(custom, 2);
  write(file);
  const GltfScene scene = parse_gltf_scene(document_.json);
  const AccessorReader reader(scene, document_.bytes);
  const GltfPrimitive &moving = scene.meshes[0].primitives[0], &still = scene.meshes[1].primitives[0];
  ASSERT_EQ(moving.attributes.size(), still.attributes.size());
  std::vector<int> rows(36);
  std::iota(rows.begin(), rows.end(), 0);
  for (const auto& [semantic, accessor] : moving.attributes) {
    const RawElements copy = reader.elements(accessor, rows);
    std::vector<int> of_file = rows;
    for (int& row : of_file) row += 27;  // ring 3 on
    const RawElements original = reader.elements(still.attributes.at(semantic), of_file);
    EXPECT_EQ(copy.bytes, original.bytes) << semantic;
    EXPECT_EQ(copy.component_type, original.component_type) << semantic;
    EXPECT_EQ(copy.normalized, original.normalized) << semantic;
  }
}

TEST_F(SplitSource, TheStillFacesOfASkinnedMeshHangOnTheSameJoints) {
  const GltfBuilder file = skinned_tube();
  write(file, {.options = [](GltfOptions& options) { options.merge_into = "Walk"; }});
  EXPECT_EQ(root_["nodes"][2], json({{"name", "tube_still"}, {"mesh", 1}, {"skin", 0}}));
  EXPECT_EQ(root_["scenes"][0]["nodes"], json({0, 1, 2})) << "beside the solved one, since joints place both";
  EXPECT_EQ(root_["nodes"][0], file.root["nodes"][0]);
  EXPECT_EQ(root_["skins"], file.root["skins"]);
  ASSERT_EQ(root_["animations"].size(), 1u);
  EXPECT_EQ(root_["animations"][0]["channels"][0], file.root["animations"][0]["channels"][0]);
  EXPECT_EQ(root_["animations"][0]["channels"][1]["target"], json({{"node", 0}, {"path", "weights"}}));
}

TEST_F(SplitSource, AMeshWithTargetsOfItsOwnStaysWhole) {
  const GltfReport report = write(tube_with_targets());
  EXPECT_EQ(report.splits.at(0).why_whole, "it has targets of its own");
  EXPECT_EQ(report.target_vertices, report.vertices);
  EXPECT_EQ(read_file(split()), read_file(whole()));
}

TEST_F(SplitSource, HalfOrMoreMovingChangesNoByte) {
  for (const flexkey::testing::Motion& motion :
       {flexkey::testing::Motion(twist), flexkey::testing::Motion(stay)}) {
    const GltfReport report = write(two_tubes(), {.motion = motion});
    EXPECT_NE(report.splits.at(0).why_whole, "");
    EXPECT_EQ(read_file(split()), read_file(whole()));
  }
}

TEST_F(SplitSource, AnInstancedNodeStaysWhole) {
  GltfBuilder file = tube_file();
  file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"] = {{"attributes", json::object()}};
  EXPECT_EQ(write(file).splits.at(0).why_whole, "its node shows it many times");
}

TEST_F(SplitSource, ANodeThatNeverMovesIsLeftAlone) {
  GltfBuilder file = tube_file();
  file.add("nodes", {{"name", "other"}, {"mesh", 0}, {"translation", {0, 0, -9}}});
  file.root["scenes"][0]["nodes"] = {0, 1};
  const GltfReport report = write(file);
  EXPECT_EQ(root_["nodes"][1], file.root["nodes"][1]);
  EXPECT_EQ(root_["meshes"][0], file.root["meshes"][0]) << "the one that does not move";
  EXPECT_EQ(root_["nodes"][0]["mesh"], 1);
  ASSERT_EQ(root_["animations"][0]["channels"].size(), 1u);
  EXPECT_EQ(root_["animations"][0]["channels"][0]["target"]["node"], 0);
  EXPECT_EQ(report.vertices, 126);
  EXPECT_EQ(report.target_vertices, 36);
  EXPECT_EQ(report.splits.at(1).targeted, 0);
  expect_same_but_split(split(), whole(), frames, 1e-7);
}

TEST_F(SplitSource, NodesMoveInTheirOwnSpace) {
  const auto bend = [](const Vec3& p, int frame) -> Vec3 { return p.x() > 3 ? bend_the_end(p, frame) : p; };
  const GltfReport report = write(two_tubes(), {.motion = bend});
  EXPECT_LT(report.error, 1e-6);
  EXPECT_EQ(report.splits.at(0).targeted, 0);
  EXPECT_EQ(root_["nodes"][2]["children"], json({3}));
  expect_same_but_split(split(), whole(), frames, 1e-7);
}

TEST_F(SplitSource, PrimitivesMoveStayOrPart) {
  GltfBuilder file = tube_file();
  json& primitives = file.root["meshes"][0]["primitives"];
  json low = add_tube(file, {.columns = 8, .rings = 3}), high = low;
  std::vector<Vec3> points = Tube{.columns = 8, .rings = 3}.points();
  for (Vec3& p : points) p.z() += 6;
  high["attributes"]["POSITION"] = file.add_points(points);
  for (json& one : {std::ref(low), std::ref(high)})
    one["material"] = file.add("materials", {{"name", "more"}});
  primitives.push_back(low);
  primitives.push_back(high);
  primitives.push_back(low);
  write(file);
  ASSERT_EQ(root_["meshes"][0]["primitives"].size(), 2u);
  ASSERT_EQ(root_["meshes"][1]["primitives"].size(), 3u);
  json moved = primitive(0, 1);
  moved.erase("targets");
  EXPECT_EQ(moved, high) << "it moves as it is";
  EXPECT_EQ(primitive(1, 1), low) << "it stays as it is";
  EXPECT_EQ(primitive(1, 2), low);
  EXPECT_EQ(primitive(0, 0)["targets"].size(), primitive(0, 1)["targets"].size());
  expect_same_but_split(split(), whole(), frames, 1e-7);
}

TEST_F(SplitSource, PrimitivesThatShareVerticesGetTheirOwn) {
  GltfBuilder file = tube_file();
  json& primitives = file.root["meshes"][0]["primitives"];
  const std::vector<std::uint16_t> all = Tube().indices();
  const std::ptrdiff_t bottom = 8 * 6 * 5;  // corners of all rings but the top one
  json high = primitives[0];
  primitives[0]["indices"] = file.add_indices({all.begin(), all.begin() + bottom});
  high["indices"] = file.add_indices({all.begin() + bottom, all.end()});
  primitives.push_back(high);
  const GltfReport report = write(file);
  EXPECT_EQ(count_of(primitive(0, 1)), 18u) << "two rings";
  EXPECT_EQ(root_["meshes"][1]["primitives"].size(), 1u);
  EXPECT_EQ(report.vertices, 126);
  EXPECT_EQ(report.target_vertices, 27 + 18);
  expect_same_but_split(split(), whole(), frames, 1e-7);
}

/// The tube's triangles as a strip a column, joined by triangles that name a vertex twice, or one by one
/// without indices.
TEST_F(SplitSource, PartsStripsAndTrianglesWithoutIndices) {
  const Tube tube;
  std::vector<std::uint16_t> strip;
  for (int column = 0; column < tube.columns; ++column) {
    if (column > 0) strip.insert(strip.end(), {strip.back(), static_cast<std::uint16_t>(column)});
    for (int ring = 0; ring <= tube.rings; ++ring)
      for (const int side : {0, 1})
        strip.push_back(static_cast<std::uint16_t>(ring * (tube.columns + 1) + column + side));
  }
  GltfBuilder stripped = tube_file(), loose = tube_file();
  json& one = stripped.root["meshes"][0]["primitives"][0];
  one["indices"] = stripped.add_indices(strip);
  one["mode"] = 5;
  std::vector<Vec3> points, normals;
  for (const std::uint16_t v : tube.indices()) {
    points.push_back(tube.points()[v]);
    normals.push_back(tube.normals()[v]);
  }
  loose.root["meshes"][0]["primitives"] = {
      {{"attributes", {{"POSITION", loose.add_points(points)}, {"NORMAL", loose.add_points(normals)}}}}};
  for (const GltfBuilder& file : {stripped, loose}) {
    write(file);
    for (const std::size_t mesh : {0u, 1u}) {
      EXPECT_TRUE(primitive(mesh).contains("indices"));
      EXPECT_FALSE(primitive(mesh).contains("mode"));
    }
    expect_same_but_split(split(), whole(), frames, 1e-7);
  }
}

TEST_F(SplitSource, ExtensionsThatMayNameVerticesKeepAPrimitiveWhole) {
  GltfBuilder file = tube_file();
  const json variants = {{"mappings", {{{"material", 0}, {"variants", {0}}}}}};
  file.root["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"] = variants;
  EXPECT_EQ(write(file).splits.at(0).why_whole, "");
  for (const std::size_t mesh : {0u, 1u})
    EXPECT_EQ(primitive(mesh)["extensions"]["KHR_materials_variants"], variants);
  file.root["meshes"][0]["primitives"][0]["extensions"]["VENDOR_outline"] = {{"indices", 0}};
  EXPECT_EQ(write(file).splits.at(0).why_whole, "faces that move name all of its vertices");
}

TEST_F(SplitSource, GroupsKeepTheirFaces) {
  GltfBuilder file = tube_file();
  file.root["meshes"][0]["primitives"][0]["extras"]["groups"] = {
      {{"name", "ends"}, {"triangles", {0, 16, 80, 16}}}, {{"name", "middle"}, {"triangles", {16, 64}}}};
  write(file);
  EXPECT_EQ(primitive(0)["extras"]["groups"], json({{{"name", "ends"}, {"triangles", {32, 16}}},
                                                    {{"name", "middle"}, {"triangles", {0, 32}}}}));
  EXPECT_EQ(primitive(1)["extras"]["groups"], json({{{"name", "ends"}, {"triangles", {0, 16}}},
                                                    {{"name", "middle"}, {"triangles", {16, 32}}}}));
}

TEST_F(SplitSource, WithoutNormalsBothSidesShadeFlat) {
  write(tube_file(), {.options = [](GltfOptions& options) { options.normals = false; }});
  for (const std::size_t mesh : {0u, 1u}) EXPECT_FALSE(primitive(mesh)["attributes"].contains("NORMAL"));
  EXPECT_EQ(count_of(primitive(0)), 27u);
  expect_same_but_split(split(), whole(), frames, 1e-7);
}

TEST_F(SplitSource, ASplitFileIsSolvedAsOneSurfaceAgain) {
  write(tube_file());
  const GltfFile again = read_gltf(split());
  EXPECT_EQ(again.source.nodes.size(), 2u);
  EXPECT_EQ(again.file.mesh.face_count(), Tube().face_count());
}

TEST_F(SplitSource, TheValidatorFindsNoError) {
  if (!has_validator()) GTEST_SKIP() << "glTF-Validator is not installed: run `npm ci` in " VALIDATE_FOLDER;
  std::vector<std::filesystem::path> files;
  for (const GltfBuilder& file : {tube_file(), skinned_tube()})
    for (const bool web : {false, true}) {
      write(file, {.options = [&](GltfOptions& options) {
              options.handles = {{"tip", {0, 0, 6}, std::vector<Eigen::Matrix4d>(frames)}};
              for (int k = 0; k < frames; ++k)
                options.handles[0].matrices[static_cast<std::size_t>(k)] =
                    (1.0 + 0.1 * k) * Eigen::Matrix4d::Identity();
              if (!web) return;
              options.basis = BasisKind::pca;
              options.encoding = Encoding::meshopt;
            }});
      files.push_back(folder_ / std::to_string(files.size()).append(".glb"));
      std::filesystem::copy_file(split(), files.back());
    }
  const Outcome outcome = validate(files);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  for (std::size_t k = 0; k < files.size(); ++k)
    EXPECT_THAT(outcome.output, HasSubstr(files[k].filename().string() + ": 0 errors"));
  EXPECT_THAT(outcome.output, Not(HasSubstr("NODE_SKINNED_MESH_NON_ROOT")));
}

}  // namespace
}  // namespace flexkey::testing
