#include "flexkey/gltf/read_gltf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <Eigen/Geometry>

#include "flexkey/mesh/defects.h"
#include "flexkey/mesh/weld.h"
#include "gltf/clips.h"
#include "gltf/images.h"
#include "support/gltf_builder.h"

namespace flexkey::testing {
namespace {

using json = nlohmann::json;
using meshes::GltfBuilder;
using meshes::Tube;
using meshes::tube_file;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ReadGltf : public ::testing::Test {
 protected:
  GltfFile read(const GltfBuilder& file, const std::vector<std::string>& names = {}) const {
    return read_gltf(file.save(folder_ / "pig.glb"), names);
  }
  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

  TemporaryFolder folder_;
};

/// The mesh's positions as points.
std::vector<Vec3> points_of(const Mesh& mesh) {
  std::vector<Vec3> points;
  for (const auto& row : mesh.positions.rowwise()) points.push_back(row.transpose());
  return points;
}

void expect_near(const std::vector<Vec3>& found, const std::vector<Vec3>& wanted, double within = 1e-6) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t v = 0; v < found.size(); ++v) EXPECT_LT((found[v] - wanted[v]).norm(), within) << v;
}

/// A triangle in the plane z = 0, counter-clockwise seen from +z, as a primitive.
json add_triangle(GltfBuilder& file) {
  return {{"attributes", {{"POSITION", file.add_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})}}}};
}

TEST_F(ReadGltf, GivesTheAccessorsVerticesInTheirOrder) {
  const GltfFile found = read(tube_file());
  const Tube tube;
  expect_near(points_of(found.file.mesh), tube.points());
  EXPECT_EQ(found.file.mesh.face_count(), tube.face_count());
  EXPECT_EQ(std::vector<int>(found.file.mesh.corners.begin(), found.file.mesh.corners.begin() + 6),
            (std::vector<int>{0, 1, 10, 0, 10, 9}));
  EXPECT_THAT(found.file.warnings, IsEmpty());
  EXPECT_THAT(found.file.inputs, IsEmpty());
  ASSERT_EQ(found.source.nodes.size(), 1u);
  const SolvedNode& node = found.source.nodes[0];
  EXPECT_EQ(node.name, "tube");
  ASSERT_EQ(node.primitives.size(), 1u);
  EXPECT_EQ(node.primitives[0].vertex_count, tube.vertex_count());
  EXPECT_TRUE(node.primitives[0].has_normals);
  const Positions& normals = found.source.normals;
  EXPECT_LT((normals.row(3).transpose() - tube.normals()[3]).norm(), 1e-6);
}

TEST_F(ReadGltf, WeldsTheSeamOfTextureCoordinates) {
  const GltfFile found = read(tube_file());
  const Mesh surface = weld(found.file.mesh).surface;
  EXPECT_EQ(surface.vertex_count(), 8 * 7);
  EXPECT_EQ(boundary_loops(surface).size(), 2u);
  EXPECT_TRUE(find_defects(surface).none());
}

TEST_F(ReadGltf, MakesGroupsOfNodesAndMaterialsOfMaterials) {
  GltfBuilder file = tube_file();
  file.root["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0.2, 0.5, 1.0, 0.25};
  const Mesh mesh = read(file).file.mesh;
  ASSERT_EQ(mesh.groups.size(), 1u);
  EXPECT_EQ(mesh.groups[0].name, "tube");
  EXPECT_EQ(mesh.groups[0].faces.size(), 96u);
  ASSERT_EQ(mesh.materials.size(), 1u);
  EXPECT_EQ(mesh.materials[0].name, "skin");
  EXPECT_NEAR(mesh.materials[0].base_color.x(), 0.4845, 1e-4);  // 0.2 in sRGB
  EXPECT_EQ(mesh.materials[0].opacity, 0.25);
  EXPECT_EQ(mesh.face_material, std::vector<int>(96, 0));
}

TEST_F(ReadGltf, ReadsTheGroupsThatFlexkeyWrites) {
  GltfBuilder file = tube_file();
  json& primitive = file.root["meshes"][0]["primitives"][0];
  primitive["extras"]["groups"] = {{{"name", "tip"}, {"triangles", {90, 6, 2, 1, 95, 1000}}}};
  const Mesh mesh = read(file).file.mesh;
  ASSERT_EQ(mesh.groups.size(), 2u);
  EXPECT_EQ(mesh.groups[0].name, "tip");
  EXPECT_THAT(mesh.groups[0].faces, ElementsAre(2, 90, 91, 92, 93, 94, 95));
}

TEST_F(ReadGltf, ForeignExtrasAreNoGroups) {
  for (const json& extras : {json("text"), json::array({1}), json{{"groups", 7}}, json{{"groups", {1, 2}}},
                             json{{"groups", {{{"name", "a"}, {"triangles", {-1, 2}}}}}},
                             json{{"groups", {{{"name", "a"}, {"triangles", {1}}}}}}}) {
    GltfBuilder file = tube_file();
    file.root["meshes"][0]["primitives"][0]["extras"] = extras;
    EXPECT_EQ(read(file).file.mesh.groups.size(), 1u) << extras;
  }
}

TEST_F(ReadGltf, PutsNodesWhereTheirParentsPutThem) {
  GltfBuilder file;
  file.add("meshes", {{"primitives", {add_triangle(file)}}});
  const double half = std::sqrt(0.5);
  file.add("nodes", {{"children", {1}}, {"translation", {10, 0, 0}}, {"rotation", {0, 0, half, half}}});
  file.add("nodes", {{"mesh", 0}, {"scale", {2, 3, 1}}});
  file.add("nodes", {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 5, 6, 7, 1}}});
  file.add("scenes", {{"nodes", {0, 2}}});
  const GltfFile found = read(file);
  // Scaled, then turned by 90 degrees about z, then moved; and y becomes z.
  expect_near(points_of(found.file.mesh),
              {{10, 0, 0}, {10, 2, 0}, {7, 0, 0}, {5, 6, 7}, {6, 6, 7}, {5, 6, 8}});
  EXPECT_EQ(found.source.nodes[0].name, "node 1");
  EXPECT_EQ(found.source.nodes[1].primitives[0].first_vertex, 3);
  const Vec3 moved = (found.source.nodes[0].world * Eigen::Vector4d(1, 1, 0, 1)).head<3>();
  EXPECT_LT((moved - Vec3(7, 2, 0)).norm(), 1e-12);
}

TEST_F(ReadGltf, AMirroringNodeKeepsItsFacesOutside) {
  GltfBuilder file;
  file.add("meshes", {{"primitives", {add_triangle(file)}}});
  file.add("nodes", {{"mesh", 0}, {"scale", {-1, 1, 1}}});
  const Mesh mesh = read(file).file.mesh;
  EXPECT_LT((vertex_normals(mesh, mesh.positions).row(0) - Eigen::RowVector3d(0, 0, 1)).norm(), 1e-12);
}

TEST_F(ReadGltf, ReadsInterleavedAttributes) {
  GltfBuilder file;
  const std::vector<float> rows = {0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1};
  const int view = file.add_view(rows, {{"byteStride", 24}});
  const auto accessor = [&](int offset) {
    return file.add("accessors", {{"bufferView", view},
                                  {"byteOffset", offset},
                                  {"componentType", 5126},
                                  {"count", 3},
                                  {"type", "VEC3"}});
  };
  const json attributes = {{"POSITION", accessor(0)}, {"NORMAL", accessor(12)}};
  file.add("meshes", {{"primitives", {{{"attributes", attributes}}}}});
  file.add("nodes", {{"mesh", 0}});
  const GltfFile found = read(file);
  expect_near(points_of(found.file.mesh), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_EQ(found.source.normals, Positions(Eigen::RowVector3d(0, 0, 1).replicate(3, 1)));
}

TEST_F(ReadGltf, ReadsQuantizedPositions) {
  GltfBuilder file;
  // Rows of three shorts, and two bytes of padding after each.
  const std::vector<std::int16_t> rows = {-32768, 0, 0, 0, 32767, 0, 0, 0, 0, 32767, 0, 0};
  const int view = file.add_view(rows, {{"byteStride", 8}});
  const int positions = file.add(
      "accessors",
      {{"bufferView", view}, {"componentType", 5122}, {"normalized", true}, {"count", 3}, {"type", "VEC3"}});
  const int normals = file.add_accessor(std::vector<std::int8_t>{0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0}, 4,
                                        {{"normalized", true}});
  file.root["accessors"][static_cast<std::size_t>(normals)]["type"] = "VEC3";
  file.root["bufferViews"].back()["byteStride"] = 4;
  file.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}}}}});
  file.add("nodes", {{"mesh", 0}, {"scale", {3, 3, 3}}, {"translation", {1, 1, 1}}});
  file.root["extensionsRequired"] = {"KHR_mesh_quantization"};
  const GltfFile found = read(file);
  expect_near(points_of(found.file.mesh), {{-2, 1, 1}, {4, 1, 1}, {1, 4, 1}}, 1e-12);
  EXPECT_EQ(found.source.normals.row(2), Eigen::RowVector3d(0, 0, 1));
}

TEST_F(ReadGltf, ReadsSparsePositions) {
  GltfBuilder file;
  const json primitive = add_triangle(file);
  const auto sparse = [&](const std::vector<std::uint8_t>& rows, const std::vector<float>& values) {
    return json{{"count", rows.size()},
                {"indices", {{"bufferView", file.add_view(rows)}, {"componentType", 5121}}},
                {"values", {{"bufferView", file.add_view(values)}}}};
  };
  file.root["accessors"][0]["sparse"] = sparse({1}, {9, 8, 7});
  const int zeros = file.add("accessors", {{"componentType", 5126},
                                           {"count", 3},
                                           {"type", "VEC3"},
                                           {"sparse", sparse({0, 2}, {1, 2, 3, 4, 5, 6})}});
  file.add("meshes", {{"primitives", {primitive, {{"attributes", {{"POSITION", zeros}}}}}}});
  file.add("nodes", {{"mesh", 0}});
  expect_near(points_of(read(file).file.mesh),
              {{0, 0, 0}, {9, 8, 7}, {0, 1, 0}, {1, 2, 3}, {0, 0, 0}, {4, 5, 6}});
}

TEST_F(ReadGltf, ReadsStripsAndFans) {
  GltfBuilder file;
  const int square = file.add_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  const int round = file.add_accessor(std::vector<std::uint8_t>{0, 1, 3, 2}, 1);
  file.add("meshes", {{"primitives",
                       {{{"attributes", {{"POSITION", square}}}, {"mode", 5}},
                        {{"attributes", {{"POSITION", square}}}, {"indices", round}, {"mode", 6}}}}});
  file.add("nodes", {{"mesh", 0}});
  const GltfFile found = read(file);
  const Mesh& mesh = found.file.mesh;
  EXPECT_EQ(mesh.vertex_count(), 4) << "primitives of the same accessors share their vertices";
  EXPECT_EQ(mesh.corners, (std::vector<int>{0, 1, 2, 1, 3, 2, 1, 3, 0, 3, 2, 0}));
  EXPECT_EQ(found.source.nodes[0].primitives[1].first_vertex, 0);
}

TEST_F(ReadGltf, PointsAndLinesGiveVerticesAlone) {
  GltfBuilder file;
  json lines = add_triangle(file);
  lines["mode"] = 1;
  file.add("meshes", {{"primitives", {lines, add_triangle(file)}}});
  file.add("nodes", {{"mesh", 0}});
  const GltfFile found = read(file);
  EXPECT_EQ(found.file.mesh.vertex_count(), 6);
  EXPECT_EQ(found.file.mesh.face_count(), 1);
  EXPECT_THAT(found.file.warnings, ElementsAre(HasSubstr("primitive 0 of mesh 0 has no triangles")));
}

TEST_F(ReadGltf, ReadsBuffersBesideTheFileAndInIt) {
  GltfBuilder file = tube_file();
  const std::vector<Vec3> wanted = points_of(read(file).file.mesh);
  write("my data.bin", file.bytes);
  const json plain = file.root;

  file.root["buffers"] = {{{"byteLength", file.bytes.size()}, {"uri", "my%20data.bin"}}};
  const GltfFile beside = read_gltf(write("beside.gltf", file.root.dump(2)));
  EXPECT_EQ(points_of(beside.file.mesh), wanted);
  EXPECT_THAT(beside.file.inputs, ElementsAre(folder_ / "my data.bin"));

  // "AAAAAAAAgD8AAABA" is 0, 1, 2 in floats; the media type does not matter.
  GltfBuilder embedded;
  embedded.root["buffers"] = {{{"byteLength", 12}, {"uri", "data:model/any;base64,AAAAAAAAgD8AAABA"}}};
  embedded.root["bufferViews"] = {{{"buffer", 0}, {"byteLength", 12}}};
  embedded.root["accessors"] = {{{"bufferView", 0}, {"componentType", 5126}, {"count", 1}, {"type", "VEC3"}}};
  const int corners = embedded.add(
      "accessors", {{"bufferView", 0}, {"componentType", 5121}, {"count", 3}, {"type", "SCALAR"}});
  embedded.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", corners}}}}});
  embedded.add("nodes", {{"mesh", 0}});
  expect_near(points_of(read_gltf(write("in.gltf", "\xEF\xBB\xBF\n" + embedded.root.dump())).file.mesh),
              {{0, 1, 2}});
}

TEST_F(ReadGltf, GathersTwoBuffersInOne) {
  GltfBuilder file = tube_file();
  const std::string other = std::string("xyz!") + file.bytes;
  write("a.bin", "pad");
  write("b.bin", other);
  file.root["buffers"] = {{{"byteLength", 3}, {"uri", "a.bin"}},
                          {{"byteLength", other.size()}, {"uri", "b.bin"}}};
  for (json& view : file.root["bufferViews"]) {
    view["buffer"] = 1;
    view["byteOffset"] = view["byteOffset"].get<int>() + 4;
  }
  const GltfFile found = read_gltf(write("two.gltf", file.root.dump()));
  expect_near(points_of(found.file.mesh), Tube().points());
  const json gathered = json::parse(found.source.document.json);
  EXPECT_EQ(gathered["buffers"],
            json::parse(R"([{"byteLength": )" + std::to_string(found.source.document.bytes.size()) + "}]"));
  EXPECT_EQ(found.file.inputs.size(), 2u);
}

TEST_F(ReadGltf, TakesImagesIn) {
  GltfBuilder file = tube_file();
  write("skin.png", red_png());
  file.root["images"] = {
      {{"uri", "skin.png"}, {"name", "skin"}}, {{"uri", "missing.png"}}, {{"uri", "../out.png"}}};
  const GltfFile found = read(file);
  const json images = json::parse(found.source.document.json)["images"];
  EXPECT_EQ(images[0]["name"], "skin");
  EXPECT_EQ(images[0]["mimeType"], "image/png");
  EXPECT_FALSE(images[0].contains("uri"));
  const json view =
      json::parse(found.source.document.json)["bufferViews"][images[0]["bufferView"].get<std::size_t>()];
  const std::string stored(reinterpret_cast<const char*>(found.source.document.bytes.data()) +
                               view["byteOffset"].get<std::size_t>(),
                           view["byteLength"].get<std::size_t>());
  EXPECT_EQ(stored, red_png());
  EXPECT_EQ(images[1], (json{{"uri", "missing.png"}}));
  EXPECT_THAT(found.file.warnings,
              ElementsAre(HasSubstr("pig.glb: image 1 ('missing.png') stays outside: there is no such file"),
                          HasSubstr("image 2 ('../out.png') stays outside: it does not lie in the folder")));
  EXPECT_THAT(found.file.inputs, ElementsAre(folder_ / "skin.png"));
}

TEST_F(ReadGltf, KeepsWhatItDoesNotKnow) {
  GltfBuilder file = tube_file();
  file.root["extras"] = {{"author", "me"}, {"a", 1}};
  file.root["extensionsUsed"] = {"VENDOR_unknown"};
  file.root["extensionsRequired"] = {"VENDOR_unknown"};
  file.root["extensions"]["VENDOR_unknown"] = {{"x", {1, 2.5, nullptr}}};
  file.root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
  const json kept = json::parse(read(file).source.document.json);
  for (const char* key :
       {"extras", "extensionsUsed", "extensionsRequired", "extensions", "cameras", "meshes", "accessors"})
    EXPECT_EQ(kept[key], file.root[key]) << key;
}

/// Three nodes: body with a mesh, hat > feather, of which hat has none.
GltfBuilder three_nodes() {
  GltfBuilder file;
  for (const char* name : {"body mesh", "feather mesh"})
    file.add("meshes", {{"name", name}, {"primitives", {add_triangle(file)}}});
  file.add("nodes", {{"name", "body"}, {"mesh", 0}});
  file.add("nodes", {{"name", "hat"}, {"children", {2}}, {"translation", {0, 0, 5}}});
  file.add("nodes", {{"name", "feather"}, {"mesh", 1}});
  file.add("scenes", {{"nodes", {0, 1}}});
  return file;
}

std::vector<int> nodes_of(const GltfFile& file) {
  std::vector<int> nodes;
  for (const SolvedNode& node : file.source.nodes) nodes.push_back(node.node);
  return nodes;
}

TEST_F(ReadGltf, ReadsCustomAttributesOfOneNumber) {
  GltfBuilder file;
  json masked = add_triangle(file), plain = add_triangle(file);
  masked["attributes"]["_MASK"] =
      file.add_accessor(std::vector<std::uint8_t>{0, 51, 255}, 1, {{"normalized", true}});
  masked["attributes"]["_PAIR"] = file.add_accessor(std::vector<float>{0, 1, 2, 3, 4, 5}, 2);
  file.add("meshes", {{"primitives", {plain, masked}}});
  file.add("nodes", {{"mesh", 0}});
  file.add("scenes", {{"nodes", {0}}});
  const Mesh mesh = read(file).file.mesh;
  ASSERT_EQ(mesh.attributes.size(), 1u);
  EXPECT_EQ(mesh.attributes[0].name, "_MASK");
  ASSERT_EQ(mesh.attributes[0].values.size(), 6);
  EXPECT_TRUE(mesh.attributes[0].values.head(3).array().isNaN().all());
  EXPECT_TRUE(mesh.attributes[0].values.tail(3).isApprox(Vec3(0, 0.2, 1), 1e-6));
  masked["attributes"]["_MASK"] = file.add_accessor(std::vector<float>{0, 1}, 1);
  file.root["meshes"][0]["primitives"][1] = masked;
  EXPECT_THROW(read(file), InputError);
}

TEST_F(ReadGltf, SolvesAllNodesOrThoseThatAreNamed) {
  const GltfBuilder file = three_nodes();
  EXPECT_THAT(nodes_of(read(file)), ElementsAre(0, 2));
  EXPECT_THAT(nodes_of(read(file, {"feather"})), ElementsAre(2));
  EXPECT_THAT(nodes_of(read(file, {"feather", "body"})), ElementsAre(0, 2)) << "in the file's order";
  EXPECT_THAT(nodes_of(read(file, {"hat"})), ElementsAre(2)) << "what is below a node without a mesh";
  EXPECT_EQ(read(file, {"hat"}).file.mesh.positions(0, 2), 5);
}

TEST_F(ReadGltf, ANamelessNodeBearsItsMeshsName) {
  GltfBuilder file = three_nodes();
  file.root["nodes"][2].erase("name");
  EXPECT_THAT(nodes_of(read(file, {"feather mesh"})), ElementsAre(2));
}

TEST_F(ReadGltf, AnUnknownNodeIsAnsweredWithTheNearest) {
  try {
    read(three_nodes(), {"body", "fether"});
    FAIL() << "there is no such node";
  } catch (const UnknownNodeError& error) {
    EXPECT_STREQ(error.what(), "no node 'fether' in pig.glb; did you mean 'feather'?");
    EXPECT_EQ(error.which(), 1u);
  }
}

TEST_F(ReadGltf, NodesOutsideTheDefaultSceneAreSolvedWhereTheyAreNamed) {
  GltfBuilder file = three_nodes();
  file.root["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
  EXPECT_THAT(nodes_of(read(file)), ElementsAre(0));
  EXPECT_THAT(nodes_of(read(file, {"feather"})), ElementsAre(2));
  file.root["scene"] = 1;
  EXPECT_THAT(nodes_of(read(file)), ElementsAre(2));
}

TEST_F(ReadGltf, ClosesTheSeamThatRoundingOpensBetweenNodes) {
  GltfBuilder file;
  // Two squares whose common edge is at x = 0.7 by floats of different size.
  const json left = {{"attributes", {{"POSITION", file.add_points({{0, 0, 0}, {0.7, 0, 0}, {0.7, 1, 0}})}}}};
  const json right = {
      {"attributes", {{"POSITION", file.add_points({{-9.3, 0, 0}, {0, 0, 0}, {-9.3, 1, 0}})}}}};
  file.add("meshes", {{"primitives", {left}}});
  file.add("meshes", {{"primitives", {right}}});
  file.add("nodes", {{"mesh", 0}});
  file.add("nodes", {{"mesh", 1}, {"translation", {10, 0, 0}}});
  const Mesh mesh = read(file).file.mesh;
  EXPECT_EQ(mesh.positions.row(3), mesh.positions.row(1));
  EXPECT_EQ(weld(mesh).surface.vertex_count(), 4);
}

TEST_F(ReadGltf, ASkinnedMeshIsInItsBindPose) {
  GltfBuilder file;
  file.add("meshes", {{"primitives", {add_triangle(file)}}});
  file.add("nodes", {{"mesh", 0}, {"skin", 0}, {"translation", {7, 7, 7}}});
  file.add("nodes", {{"name", "joint"}, {"translation", {1, 2, 3}}});
  file.add("skins", {{"joints", {1}}});
  expect_near(points_of(read(file).file.mesh), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
}

/// A view compressed with EXT_meshopt_compression, in a buffer of its own behind a fallback.
void compress(GltfBuilder& file, int view_index, const std::string& encoded, const json& extension) {
  json& view = file.root["bufferViews"][static_cast<std::size_t>(view_index)];
  json compression = {{"buffer", 0}, {"byteOffset", file.bytes.size()}, {"byteLength", encoded.size()}};
  compression.update(extension);
  file.bytes += encoded;
  file.bytes.resize((file.bytes.size() + 3) / 4 * 4);
  view["buffer"] = 1;
  view["byteOffset"] = 0;
  view["extensions"]["EXT_meshopt_compression"] = compression;
}

GltfBuilder compressed_tube() {
  GltfBuilder file;
  const Tube tube;
  const std::vector<float> points = GltfBuilder::floats_of(tube.points());
  std::vector<unsigned> corners;
  for (const std::uint16_t corner : tube.indices()) corners.push_back(corner);
  const std::size_t vertices = static_cast<std::size_t>(tube.vertex_count());
  std::string vertex_code(meshopt_encodeVertexBufferBound(vertices, 12), '\0'),
      index_code(meshopt_encodeIndexBufferBound(corners.size(), vertices), '\0');
  vertex_code.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(vertex_code.data()),
                                                vertex_code.size(), points.data(), vertices, 12));
  index_code.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(index_code.data()),
                                              index_code.size(), corners.data(), corners.size()));

  file.bytes = "junk";
  file.root["bufferViews"] = {{{"buffer", 1}, {"byteLength", points.size() * 4}},
                              {{"buffer", 1}, {"byteLength", corners.size() * 2}}};
  compress(file, 0, vertex_code, {{"mode", "ATTRIBUTES"}, {"byteStride", 12}, {"count", vertices}});
  compress(file, 1, index_code, {{"mode", "TRIANGLES"}, {"byteStride", 2}, {"count", corners.size()}});
  file.root["buffers"] = {
      {{"byteLength", file.bytes.size()}},
      {{"byteLength", 100000}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  file.root["accessors"] = {
      {{"bufferView", 0}, {"componentType", 5126}, {"count", vertices}, {"type", "VEC3"}},
      {{"bufferView", 1}, {"componentType", 5123}, {"count", corners.size()}, {"type", "SCALAR"}}};
  file.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}});
  file.add("nodes", {{"mesh", 0}});
  file.root["extensionsUsed"] = {"EXT_meshopt_compression", "OTHER"};
  file.root["extensionsRequired"] = {"EXT_meshopt_compression"};
  return file;
}

TEST_F(ReadGltf, UnpacksMeshoptCompression) {
  const GltfFile found = read(compressed_tube());
  expect_near(points_of(found.file.mesh), Tube().points());
  EXPECT_EQ(found.file.mesh.face_count(), Tube().face_count());
  EXPECT_TRUE(find_defects(weld(found.file.mesh).surface).none());
  const json unpacked = json::parse(found.source.document.json);
  EXPECT_THAT(found.source.document.json, Not(HasSubstr("EXT_meshopt_compression")));
  EXPECT_EQ(unpacked["extensionsUsed"], json::array({"OTHER"}));
  EXPECT_FALSE(unpacked.contains("extensionsRequired"));
  EXPECT_EQ(unpacked["buffers"].size(), 1u);
  EXPECT_EQ(found.source.document.bytes.size(),
            static_cast<std::size_t>(12 * Tube().vertex_count() + 2 * 3 * Tube().face_count()));
}

TEST_F(ReadGltf, WrongMeshoptDataIsAnError) {
  const auto problem_with = [&](const char* key, const json& value) -> std::string {
    GltfBuilder file = compressed_tube();
    file.root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][key] = value;
    try {
      read(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(
      problem_with("byteLength", 20),
      HasSubstr("EXT_meshopt_compression of buffer view 0 cannot be read: its data cannot be decoded"));
  EXPECT_THAT(problem_with("count", 4000000000), HasSubstr("its count is more than its data can hold"));
  EXPECT_THAT(problem_with("byteStride", 7), HasSubstr("its stride is not a multiple of 4"));
  EXPECT_THAT(problem_with("mode", "NEW"), HasSubstr("its mode is unknown"));
  EXPECT_THAT(problem_with("filter", "NEW"), HasSubstr("its filter is unknown"));
  EXPECT_THAT(problem_with("filter", "QUATERNION"), HasSubstr("a quaternion filter has a stride of 8"));
  EXPECT_THAT(problem_with("byteOffset", 1000000),
              HasSubstr("EXT_meshopt_compression of buffer view 0 reaches beyond its buffer"));
}

}  // namespace
}  // namespace flexkey::testing
