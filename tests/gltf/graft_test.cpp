// A clip grafted into the file that its mesh came from: the shape moves, everything else is as it was.
#include "flexkey/gltf/graft.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <set>
#include <utility>

#include "flexkey/gltf/following_normals.h"
#include "flexkey/gltf/gltf_scene.h"
#include "flexkey/gltf/read_accessor.h"
#include "flexkey/gltf/read_gltf.h"
#include "flexkey/gltf/write_glb.h"
#include "flexkey/mesh/read_file.h"
#include "gltf/clips.h"
#include "gltf/glb_file.h"
#include "gltf/images.h"
#include "gltf/validate.h"
#include "support/gltf_builder.h"

namespace flexkey::testing {
namespace {

using json = nlohmann::json;
using meshes::GltfBuilder;
using meshes::skinned_tube;
using meshes::Tube;
using meshes::tube_file;
using meshes::tube_with_targets;
using meshes::two_tubes;
using ::testing::HasSubstr;

/// Leans along x the more the higher, by frame: what bends the tube in scene space.
Vec3 lean(const Vec3& p, int frame) {
  return p + 0.02 * frame * p.z() * p.z() * Vec3(1, 0.5, 0);
}

struct Grafted {
  GltfFile file;
  Clip clip;
  GltfReport report;
  std::string glb;
  json root;
  tinygltf::Model model;
};

/// What a test changes of the writing.
struct Wish {
  std::string merge_into = {};
  std::vector<std::string> nodes = {};
  Encoding encoding = Encoding::floats;
  bool normals = true;
  std::vector<ClipRange> clips = {};
};

/// The JSON chunk of a GLB.
json json_of(const std::string& glb) {
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, sizeof length);
  return json::parse(glb.substr(20, length));
}

/// The file with four frames in which it leans, a target each.
Grafted graft_into(const GltfBuilder& builder, const Wish& wish = {}) {
  const TemporaryFolder folder;
  Grafted grafted;
  grafted.file = read_gltf(builder.save(folder / "in.glb"), wish.nodes);
  grafted.clip = clip_of(grafted.file.file.mesh, 4, lean);
  grafted.clip.name = "lean";
  GltfOptions options;
  options.basis = BasisKind::frames;
  options.encoding = wish.encoding;
  options.normals = wish.normals;
  options.source = &grafted.file.source;
  options.merge_into = wish.merge_into;
  options.clips = wish.clips;
  grafted.report = write_glb(grafted.clip, options, folder / "out.glb");
  grafted.glb = read_file(folder / "out.glb");
  grafted.root = json_of(grafted.glb);
  if (wish.encoding == Encoding::floats) grafted.model = load_glb(folder / "out.glb");
  return grafted;
}

/// Positions of a primitive at a frame as a client has them in the scene, #vertices x 3.
Positions played(const Grafted& grafted, std::size_t node, std::size_t primitive, std::size_t frame) {
  const SolvedNode& solved = grafted.file.source.nodes[node];
  const auto mesh = static_cast<std::size_t>(grafted.model.nodes[static_cast<std::size_t>(solved.node)].mesh);
  const tinygltf::Primitive& written = grafted.model.meshes[mesh].primitives[primitive];
  const std::size_t own = written.targets.size() - grafted.clip.frames.size();
  const Eigen::MatrixXf local =
      rows_of(grafted.model, written.attributes.at("POSITION")).cast<float>() +
      rows_of(grafted.model, written.targets[own + frame].at("POSITION")).cast<float>();
  const Positions rows = local.cast<double>();
  const Eigen::Matrix3d linear = solved.world.topLeftCorner<3, 3>();
  return (rows * linear.transpose()).rowwise() + solved.world.topRightCorner<3, 1>().transpose();
}

double playback_error(const Grafted& grafted) {
  double largest = 0;
  for (std::size_t node = 0; node < grafted.file.source.nodes.size(); ++node) {
    const SolvedNode& solved = grafted.file.source.nodes[node];
    for (std::size_t p = 0; p < solved.primitives.size(); ++p)
      for (std::size_t k = 0; k < grafted.clip.frames.size(); ++k) {
        const Positions wanted = grafted.clip.frames[k].middleRows(solved.primitives[p].first_vertex,
                                                                   solved.primitives[p].vertex_count);
        largest = std::max(largest, (played(grafted, node, p, k) - wanted).rowwise().norm().maxCoeff());
      }
  }
  return largest;
}

TEST(Graft, TheTubeLeansAndItsSeamNeverOpens) {
  const Grafted grafted = graft_into(tube_file());
  EXPECT_LT(playback_error(grafted), 1e-6);
  for (std::size_t k = 0; k < 4; ++k) {
    const Positions shape = played(grafted, 0, 0, k);
    for (int ring = 0; ring <= 6; ++ring) EXPECT_EQ(shape.row(9 * ring), shape.row(9 * ring + 8));
  }
  const tinygltf::Mesh& mesh = grafted.model.meshes[0];
  EXPECT_EQ(mesh.weights, std::vector<double>(4, 0));
  const json& extras = grafted.root["meshes"][0]["extras"];
  EXPECT_EQ(extras["targetNames"], json::array({"f0000", "f0001", "f0002", "f0003"}));
  EXPECT_EQ(extras["profile"], "exact");
  EXPECT_EQ(grafted.root["animations"][0]["extras"]["fps"], 24);
  for (const auto& target : mesh.primitives[0].targets) EXPECT_EQ(target.count("NORMAL"), 1u);
  EXPECT_LT(grafted.report.error, 1e-6);
  EXPECT_LT(grafted.report.normal_error_largest, 0.01);
  EXPECT_EQ(grafted.report.vertices, Tube().vertex_count());
}

TEST(Graft, NormalsFollowTheSurface) {
  const Grafted grafted = graft_into(tube_file());
  const FollowingNormals normals(grafted.file.file.mesh, grafted.file.source);
  const tinygltf::Primitive& written = grafted.model.meshes[0].primitives[0];
  const Eigen::MatrixXf shown = rows_of(grafted.model, written.attributes.at("NORMAL")).cast<float>() +
                                rows_of(grafted.model, written.targets[3].at("NORMAL")).cast<float>();
  const Positions wanted = normals.at(grafted.clip.frames[3]);
  EXPECT_LT((shown.cast<double>() - wanted).rowwise().norm().maxCoeff(), 1e-3);
  EXPECT_GT((wanted - grafted.file.source.normals).rowwise().norm().maxCoeff(), 0.1);
}

TEST(Graft, WithoutNormalsClientsShadeFlat) {
  GltfBuilder file = tube_with_targets();
  const Grafted grafted = graft_into(file, {.normals = false});
  const json& primitive = grafted.root["meshes"][0]["primitives"][0];
  EXPECT_FALSE(primitive["attributes"].contains("NORMAL"));
  for (const json& target : primitive["targets"]) EXPECT_EQ(target.size(), 1u) << target;
}

TEST(Graft, TheWebProfileIsReadBackAsItWas) {
  const TemporaryFolder folder;
  const Grafted grafted = graft_into(two_tubes(), {.encoding = Encoding::meshopt});
  EXPECT_THAT(grafted.root["extensionsRequired"],
              ::testing::UnorderedElementsAre("KHR_mesh_quantization", "EXT_meshopt_compression"));
  EXPECT_LE(grafted.report.error, 1e-3);
  EXPECT_GT(grafted.report.error, 0);
  std::ofstream(folder / "web.glb", std::ios::binary) << grafted.glb;
  const GltfFile again = read_gltf(folder / "web.glb");
  EXPECT_EQ(again.file.mesh.positions, grafted.file.file.mesh.positions);
  EXPECT_EQ(again.file.mesh.corners, grafted.file.file.mesh.corners);
}

TEST(Graft, NoProfileOpensTheSeam) {
  const TemporaryFolder folder;
  const GltfFile file = read_gltf(tube_file().save(folder / "in.glb"));
  for (const BasisKind basis : {BasisKind::knots, BasisKind::pca})
    for (const Encoding encoding : {Encoding::floats, Encoding::meshopt}) {
      GltfOptions options;
      options.basis = basis;
      options.encoding = encoding;
      options.source = &file.source;
      const GltfReport report = write_glb(clip_of(file.file.mesh, 12, twist), options, folder / "out.glb");
      EXPECT_LE(report.error, 1e-3);
      const GltfFile again = read_gltf(folder / "out.glb");
      const GltfScene scene = parse_gltf_scene(again.source.document.json);
      const AccessorReader reader(scene, again.source.document.bytes);
      const std::vector<GltfAttributes>& targets = scene.meshes[0].primitives[0].targets;
      ASSERT_GT(targets.size(), 0u);
      for (const GltfAttributes& target : targets)
        for (const auto& [semantic, accessor] : target) {
          const AccessorRows rows = reader.rows(accessor, 3);
          for (int ring = 0; ring <= 6; ++ring)
            EXPECT_EQ(rows.row(9 * ring), rows.row(9 * ring + 8)) << semantic;
        }
    }
}

TEST(Graft, TheWebProfileKeepsStripsAndInterleavedData) {
  GltfBuilder file;
  // Positions and, in the same rows, four bytes that are no float.
  std::vector<float> rows;
  for (const Vec3& p :
       {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 1), Vec3(1, 1, 1), Vec3(0, 2, 2), Vec3(1, 2, 2)}) {
    for (int i = 0; i < 3; ++i) rows.push_back(static_cast<float>(p[i]));
    rows.push_back(-0.0F);
  }
  const int view = file.add_view(rows, {{"byteStride", 16}, {"target", 34962}});
  const int positions =
      file.add("accessors", {{"bufferView", view}, {"componentType", 5126}, {"count", 6}, {"type", "VEC3"}});
  const int colors = file.add("accessors", {{"bufferView", view},
                                            {"byteOffset", 12},
                                            {"componentType", 5121},
                                            {"normalized", true},
                                            {"count", 6},
                                            {"type", "VEC4"}});
  const int strip = file.add_accessor(std::vector<std::uint16_t>{0, 1, 2, 3, 4, 5}, 1);
  file.root["bufferViews"].back()["target"] = 34963;
  file.add("meshes", {{"primitives",
                       {{{"attributes", {{"POSITION", positions}, {"COLOR_0", colors}}},
                         {"indices", strip},
                         {"mode", 5}}}}});
  file.add("nodes", {{"mesh", 0}});
  const TemporaryFolder folder;
  const Grafted grafted = graft_into(file, {.encoding = Encoding::meshopt});
  std::ofstream(folder / "web.glb", std::ios::binary) << grafted.glb;
  const GltfFile again = read_gltf(folder / "web.glb");
  EXPECT_EQ(again.file.mesh.corners, grafted.file.file.mesh.corners);
  const std::vector<unsigned char>& bytes = again.source.document.bytes;
  const json unpacked = json::parse(again.source.document.json);
  const std::size_t offset = unpacked["bufferViews"][static_cast<std::size_t>(view)]["byteOffset"];
  EXPECT_EQ(std::memcmp(bytes.data() + offset, rows.data(), 4 * rows.size()), 0);
}

TEST(Graft, TheFilesOwnTargetsCountAmongThoseThatAreAllowed) {
  const TemporaryFolder folder;
  const GltfFile file = read_gltf(tube_with_targets().save(folder / "in.glb"));
  GltfOptions options;
  options.basis = BasisKind::frames;
  options.source = &file.source;
  const Clip clip = clip_of(file.file.mesh, 4, lean);
  options.max_targets = 6;
  EXPECT_EQ(write_glb(clip, options, folder / "out.glb").targets, 6);
  for (options.max_targets = 1; options.max_targets < 6; ++options.max_targets)
    EXPECT_THROW(write_glb(clip, options, folder / "out.glb"), InputError) << options.max_targets;
}

TEST(Graft, EveryClipIsAnAnimation) {
  const Grafted grafted =
      graft_into(tube_file(), {.clips = {{"first", 0, 1.0 / 24}, {"rest", 1.0 / 24, 3.0 / 24}}});
  ASSERT_EQ(grafted.model.animations.size(), 2u);
  EXPECT_EQ(grafted.model.animations[1].name, "rest");
  EXPECT_EQ(grafted.root["animations"][1]["extras"]["fps"], 24);
}

TEST(Graft, TheNewAnimationPlaysATargetAFrame) {
  const Grafted grafted = graft_into(tube_file());
  ASSERT_EQ(grafted.model.animations.size(), 1u);
  EXPECT_EQ(grafted.model.animations[0].name, "lean");
  EXPECT_EQ(grafted.model.animations[0].channels[0].target_node, 0);
  for (int k = 0; k < 4; ++k) {
    std::vector<float> wanted(4, 0);
    wanted[static_cast<std::size_t>(k)] = 1;
    EXPECT_EQ(weights_at(grafted.model, static_cast<float>(k) / 24), wanted);
  }
}

TEST(Graft, EverythingElseIsAsItWas) {
  GltfBuilder file = tube_file();
  file.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {
      {"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}}}}}};
  file.add("images", {{"bufferView", file.add_view(red_png())}, {"mimeType", "image/png"}});
  file.add("textures", {{"source", 0}});
  file.root["extras"] = {{"author", "me"}};
  file.root["extensionsUsed"] = {"KHR_texture_transform", "VENDOR_thing"};
  file.root["extensions"]["VENDOR_thing"] = {{"deep", {1, {{"er", 2.5}}}}};
  file.root["meshes"][0]["extras"] = {{"mine", 1}};
  file.root["meshes"][0]["primitives"][0]["extensions"]["VENDOR_thing"] = {{"a", 1}};
  file.add("nodes", {{"name", "camera"}, {"camera", 0}, {"extras", {{"b", nullptr}}}});
  file.add("cameras", {{"type", "orthographic"},
                       {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 1}}}});
  const Grafted grafted = graft_into(file);
  const json &before = file.root, &after = grafted.root;
  for (const char* key : {"asset", "extras", "extensionsUsed", "extensions", "materials", "images",
                          "textures", "nodes", "cameras", "scenes", "scene"})
    EXPECT_EQ(after[key], before[key]) << key;
  for (const char* key : {"attributes", "indices", "material", "extensions"})
    EXPECT_EQ(after["meshes"][0]["primitives"][0][key], before["meshes"][0]["primitives"][0][key]) << key;
  EXPECT_EQ(after["meshes"][0]["extras"]["mine"], 1);
  for (const char* list : {"accessors", "bufferViews"})
    for (std::size_t i = 0; i < before[list].size(); ++i)
      EXPECT_EQ(after[list][i], before[list][i]) << list << i;
  EXPECT_EQ(grafted.glb.find(file.bytes) != std::string::npos, true) << "its bytes are all there";
}

TEST(Graft, NodesMoveInTheirOwnSpace) {
  const Grafted grafted = graft_into(two_tubes());
  EXPECT_LT(playback_error(grafted), 3e-6);
  ASSERT_EQ(grafted.root["animations"].size(), 1u);
  EXPECT_EQ(grafted.root["animations"][0]["channels"].size(), 2u);
}

TEST(Graft, AMeshThatAnotherNodeShowsTooIsCopied) {
  GltfBuilder file = tube_file();
  file.add("nodes", {{"name", "other"}, {"mesh", 0}, {"translation", {9, 0, 0}}});
  file.root["scenes"][0]["nodes"] = {0, 1};
  const Grafted one = graft_into(file, {.nodes = {"tube"}});
  EXPECT_EQ(one.root["nodes"][0]["mesh"], 1);
  EXPECT_EQ(one.root["meshes"][0], file.root["meshes"][0]) << "the other node's";
  EXPECT_LT(playback_error(one), 1e-6);
  const Grafted both = graft_into(file);
  EXPECT_EQ(both.root["meshes"].size(), 2u);
  EXPECT_NE(both.root["nodes"][0]["mesh"], both.root["nodes"][1]["mesh"]);
  EXPECT_LT(playback_error(both), 2e-6);
}

TEST(Graft, PrimitivesThatShareAccessorsShareTheirMotion) {
  GltfBuilder file = tube_file();
  json primitive = file.root["meshes"][0]["primitives"][0];
  primitive["indices"] = file.add_indices({0, 1, 10});
  file.root["meshes"][0]["primitives"].push_back(primitive);
  const Grafted grafted = graft_into(file);
  EXPECT_EQ(grafted.file.file.mesh.vertex_count(), Tube().vertex_count());
  EXPECT_LT(playback_error(grafted), 1e-6);
}

TEST(Graft, TargetsOfTheFileStayFirst) {
  const GltfBuilder file = tube_with_targets();
  const Grafted grafted = graft_into(file);
  const json& mesh = grafted.root["meshes"][0];
  EXPECT_EQ(mesh["weights"], json::array({0.25, 0.5, 0, 0, 0, 0}));
  EXPECT_EQ(mesh["extras"]["targetNames"],
            json::array({"f0001", "smile", "f0000", "f0001_2", "f0002", "f0003"}));
  const json& targets = mesh["primitives"][0]["targets"];
  ASSERT_EQ(targets.size(), 6u);
  EXPECT_EQ(targets[0]["POSITION"], file.root["meshes"][0]["primitives"][0]["targets"][0]["POSITION"]);
  EXPECT_EQ(targets[1], file.root["meshes"][0]["primitives"][0]["targets"][1]);
  for (const json& target : targets) EXPECT_TRUE(target.contains("NORMAL") && target.size() == 2) << target;
  EXPECT_TRUE(rows_of(grafted.model, targets[0]["NORMAL"]).isZero(0)) << "nothing moved that did not before";
  EXPECT_LT(playback_error(grafted), 1e-6);
}

TEST(Graft, TargetsOfOtherAttributesGetZerosOfTheirKind) {
  GltfBuilder file = tube_with_targets();
  json& targets = file.root["meshes"][0]["primitives"][0]["targets"];
  targets[0]["TEXCOORD_0"] = file.root["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"];
  const Grafted grafted = graft_into(file);
  for (const json& target : grafted.root["meshes"][0]["primitives"][0]["targets"]) {
    ASSERT_TRUE(target.contains("TEXCOORD_0"));
    EXPECT_EQ(grafted.root["accessors"][target["TEXCOORD_0"].get<std::size_t>()]["type"], "VEC2");
  }
}

TEST(Graft, WeightsThatDoNotFitTheTargetsAreAnError) {
  GltfBuilder file = tube_with_targets();
  const json sampler = file.root["animations"][0]["samplers"][0];
  file.root["accessors"][sampler["output"].get<std::size_t>()]["count"] = 2;
  try {
    graft_into(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("has 1 weights a key, and its mesh has 2 morph targets"));
  }
}

TEST(Graft, TooManyDefaultWeightsAreCut) {
  GltfBuilder file = tube_file();
  file.root["meshes"][0]["weights"] = {0.5, 0.5};
  EXPECT_EQ(graft_into(file).root["meshes"][0]["weights"], json::array({0, 0, 0, 0}));
}

TEST(Graft, TheFilesOwnAnimationsPlayAsBefore) {
  const Grafted grafted = graft_into(tube_with_targets());
  ASSERT_EQ(grafted.model.animations.size(), 2u);
  EXPECT_EQ(weights_at(grafted.model, 0.25), (std::vector<float>{0.25, 0.75, 0, 0, 0, 0})) << "Talk";
  const tinygltf::AnimationSampler& sampler = grafted.model.animations[1].samplers[0];
  const Eigen::MatrixXd weights = rows_of(grafted.model, sampler.output);
  ASSERT_EQ(weights.rows(), 4 * 6);
  EXPECT_EQ(weights(6, 0), 0.25) << "the file's own targets keep their defaults in the new animation";
  EXPECT_EQ(weights(7, 0), 0.5);
  EXPECT_EQ(weights(6 + 3, 0), 1);
}

TEST(Graft, MergesIntoAClipOfTheFile) {
  const Grafted grafted = graft_into(tube_with_targets(), {.merge_into = "Talk"});
  ASSERT_EQ(grafted.model.animations.size(), 1u);
  ASSERT_EQ(grafted.model.animations[0].channels.size(), 1u);
  EXPECT_EQ(weights_at(grafted.model, 1), (std::vector<float>{1, 0, 0, 0, 0, 1}));
  const std::vector<float> at_frame_2 = weights_at(grafted.model, 2.0F / 24);
  EXPECT_NEAR(at_frame_2[0], 2.0 / 24, 1e-6);
  EXPECT_EQ(at_frame_2[4], 1);
}

TEST(Graft, MergesIntoAClipThatMovesOtherThings) {
  GltfBuilder file = tube_file();
  const int times = file.add_accessor(std::vector<float>{0, 1}, 1),
            values = file.add_points({{0, 0, 0}, {1, 0, 0}});
  file.add("animations",
           {{"name", "Walk"},
            {"samplers", {{{"input", times}, {"output", values}}}},
            {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}});
  const Grafted grafted = graft_into(file, {.merge_into = "Walk"});
  ASSERT_EQ(grafted.model.animations.size(), 1u);
  ASSERT_EQ(grafted.model.animations[0].channels.size(), 2u);
  EXPECT_EQ(grafted.root["animations"][0]["channels"][0], file.root["animations"][0]["channels"][0]);
  EXPECT_EQ(grafted.model.animations[0].channels[1].target_path, "weights");
  try {
    graft_into(file, {.merge_into = "Wak"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no animation 'Wak' in the file of the mesh; did you mean 'Walk'?"));
  }
}

TEST(Graft, ASharedSamplerIsChangedForTheSolvedNodeAlone) {
  GltfBuilder file = tube_with_targets();
  file.add("meshes", json(file.root["meshes"][0]));
  file.add("nodes", {{"name", "twin"}, {"mesh", 1}});
  file.root["animations"][0]["channels"].push_back(
      {{"sampler", 0}, {"target", {{"node", 1}, {"path", "weights"}}}});
  const Grafted grafted = graft_into(file, {.nodes = {"tube"}});
  const json& talk = grafted.root["animations"][0];
  EXPECT_EQ(talk["samplers"][0], file.root["animations"][0]["samplers"][0]);
  EXPECT_EQ(talk["channels"][0]["sampler"], 1);
  EXPECT_EQ(talk["channels"][1]["sampler"], 0);
}

/// The accessors that the file's meshes and animations name, and how many it has.
std::pair<std::set<json>, std::size_t> accessors_of(const json& root) {
  std::set<json> named;
  for (const json& mesh : root["meshes"])
    for (const json& primitive : mesh["primitives"]) {
      named.insert(primitive["indices"]);
      for (const json& accessor : primitive["attributes"]) named.insert(accessor);
      for (const json& target : primitive["targets"])
        for (const json& accessor : target) named.insert(accessor);
    }
  for (const json& animation : root["animations"])
    for (const json& sampler : animation["samplers"])
      for (const char* key : {"input", "output"}) named.insert(sampler[key]);
  return {named, root["accessors"].size()};
}

TEST(Graft, WeightsThatAreReplacedLeaveNoAccessorBehind) {
  for (const char* merge_into : {"", "Talk"}) {
    const auto [named, count] =
        accessors_of(graft_into(tube_with_targets(), {.merge_into = merge_into}).root);
    EXPECT_EQ(named.size(), count) << merge_into;
  }
  const auto [named, count] = accessors_of(graft_into(tube_with_targets(), {.normals = false}).root);
  EXPECT_EQ(named.size(), count) << "without normals";
}

TEST(Graft, WhatAnExtensionMayNameStaysInItsPlace) {
  GltfBuilder file = tube_with_targets();
  const json output = file.root["animations"][0]["samplers"][0]["output"];
  const json before = file.root["accessors"][output.get<std::size_t>()];
  file.root["extensionsUsed"] = {"VENDOR_thing"};
  file.root["extensions"]["VENDOR_thing"] = {{"weights", output}};
  const Grafted grafted = graft_into(file);
  EXPECT_EQ(grafted.root["accessors"][output.get<std::size_t>()], before);
  EXPECT_EQ(weights_at(grafted.model, 0.25), (std::vector<float>{0.25, 0.75, 0, 0, 0, 0}));
}

TEST(Graft, SkinJointsAndClipsOfASkinnedMeshStay) {
  const GltfBuilder file = skinned_tube();
  const Grafted grafted = graft_into(file);
  EXPECT_LT(playback_error(grafted), 1e-6) << "in the bind pose";
  for (const char* key : {"skins", "nodes"}) EXPECT_EQ(grafted.root[key], file.root[key]);
  EXPECT_EQ(grafted.root["animations"][0], file.root["animations"][0]);
  for (const char* semantic : {"JOINTS_0", "WEIGHTS_0"})
    EXPECT_EQ(grafted.root["meshes"][0]["primitives"][0]["attributes"][semantic],
              file.root["meshes"][0]["primitives"][0]["attributes"][semantic]);
}

TEST(Graft, TheValidatorFindsNoError) {
  if (!has_validator()) GTEST_SKIP() << "glTF-Validator is not installed: run `npm ci` in " VALIDATE_FOLDER;
  const TemporaryFolder folder;
  std::vector<std::filesystem::path> files;
  for (const GltfBuilder& file : {tube_file(), two_tubes(), tube_with_targets(), skinned_tube()})
    for (const char* merge_into : {"", "Talk"}) {
      if (*merge_into != 0 && !file.root.contains("animations")) continue;
      GltfBuilder named = file;
      if (named.root.contains("animations")) named.root["animations"][0]["name"] = "Talk";
      files.push_back(folder / std::to_string(files.size()).append(".glb"));
      std::ofstream(files.back(), std::ios::binary) << graft_into(named, {.merge_into = merge_into}).glb;
    }
  const Outcome outcome = validate(files);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("0.glb: 0 errors, 0 warnings, 1 infos"))
      << "the file's own texture coordinates, which no texture uses";
  for (const char* name : {"2.glb", "3.glb"})  // own weights that changed
    EXPECT_THAT(outcome.output, HasSubstr(std::string(name) + ": 0 errors, 0 warnings, 1 infos"));
  EXPECT_THAT(outcome.output, HasSubstr("5.glb: 0 errors"));
}

}  // namespace
}  // namespace flexkey::testing
