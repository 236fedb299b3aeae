#include "flexkey/gltf/meshopt.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "flexkey/gltf/primitives.h"
#include "flexkey/gltf/write_glb.h"
#include "gltf/clips.h"
#include "gltf/glb_file.h"
#include "gltf/meshopt_file.h"

namespace flexkey::testing {
namespace {

GltfOptions frames_under_meshopt() {
  GltfOptions options = exact();
  options.encoding = Encoding::meshopt;
  return options;
}

/// The farthest that any vertex plays from the clip over all frames.
double farthest(const Clip& clip, const tinygltf::Model& model) {
  const Primitive primitive = split_primitives(clip.mesh)[0];
  double largest = 0;
  for (std::size_t k = 0; k < clip.frames.size(); ++k) {
    const std::vector<float> weights =
        weights_at(model, static_cast<float>(static_cast<double>(k) / clip.fps));
    const Eigen::MatrixXd solved = clip.frames[k](primitive.vertices, Eigen::all);
    const Eigen::MatrixXd off = morphed(model, 0, "POSITION", weights).cast<double>() - solved;
    largest = std::max(largest, off.rowwise().norm().maxCoeff());
  }
  return largest;
}

TEST(Meshopt, DecodesToWhatTheReportMeasured) {
  const Clip clip = clip_of(sheet(30), 12, twist);
  const TemporaryFolder folder;
  const GltfReport report = write_glb(clip, frames_under_meshopt(), folder / "shot.glb");
  const tinygltf::Model model = load_meshopt_glb(folder / "shot.glb");
  const double diagonal = bounds_of(clip.mesh.positions).diagonal();
  EXPECT_NEAR(report.error, farthest(clip, model) / diagonal, 1e-6);
  EXPECT_GT(report.error, 1e-6) << "the deltas are integers";
  EXPECT_LT(report.error, 1e-3);
  EXPECT_LT(report.normal_error_mean, 1);
}

TEST(Meshopt, IsSmallerThanFloats) {
  const Clip clip = clip_of(sheet(30), 12, twist);
  const TemporaryFolder folder;
  const auto coded = write_glb(clip, frames_under_meshopt(), folder / "coded.glb").bytes;
  EXPECT_LT(4 * coded, write_glb(clip, exact(), folder / "plain.glb").bytes);
}

TEST(Meshopt, TheTrianglesStayInTheirOrder) {
  const Clip clip = clip_of(sheet(30), 2, twist);
  const TemporaryFolder folder;
  write_glb(clip, frames_under_meshopt(), folder / "coded.glb");
  write_glb(clip, exact(), folder / "plain.glb");
  const auto triangles = [](const tinygltf::Model& model) {
    Eigen::MatrixXd corners = rows_of(model, model.meshes[0].primitives[0].indices).reshaped(3, 30 * 30 * 2);
    for (auto triangle : corners.colwise()) std::sort(triangle.begin(), triangle.end());
    return corners;  // a triangle may begin at another of its corners
  };
  EXPECT_EQ(triangles(load_meshopt_glb(folder / "coded.glb")), triangles(load_glb(folder / "plain.glb")));
}

TEST(Meshopt, SaysThatItIsRequiredAndThatTheBufferIsOnlyThereDecoded) {
  const TemporaryFolder folder;
  const GltfReport report =
      write_glb(clip_of(sheet(30), 4, twist), frames_under_meshopt(), folder / "shot.glb");
  const tinygltf::Model model = load_meshopt_glb(folder / "shot.glb");
  const std::vector<std::string> wanted = {"KHR_mesh_quantization", "EXT_meshopt_compression"};
  EXPECT_EQ(model.extensionsRequired, wanted);
  EXPECT_EQ(model.extensionsUsed, wanted);
  EXPECT_EQ(report.extensions, wanted);
}

TEST(Meshopt, LeavesWhatItCannotShrink) {
  nlohmann::json asset = {{"asset", {{"version", "2.0"}}},
                          {"buffers", {{{"byteLength", 8}}}},
                          {"bufferViews", {{{"buffer", 0}, {"byteLength", 5}}}}};
  const Glb glb{asset.dump(), {1, 2, 3, 4, 5, 0, 0, 0}};
  const Glb coded = meshopt_compressed(glb);
  asset = nlohmann::json::parse(coded.json);
  EXPECT_EQ(asset["buffers"].size(), 1u);
  EXPECT_FALSE(asset.contains("extensionsRequired"));
  EXPECT_EQ(std::vector<unsigned char>(coded.bytes.begin(), coded.bytes.begin() + 5),
            (std::vector<unsigned char>{1, 2, 3, 4, 5}));
}

TEST(Meshopt, DamagedCodeIsNotDecoded) {
  const TemporaryFolder folder;
  write_glb(clip_of(sheet(30), 4, twist), frames_under_meshopt(), folder / "shot.glb");
  std::ifstream stream(folder / "shot.glb", std::ios::binary);
  std::string file(std::istreambuf_iterator<char>(stream), {});
  stream.close();
  file.resize(file.size() - 4000);
  file.resize(file.size() + 4000);
  std::ofstream(folder / "shot.glb", std::ios::binary) << file;
  EXPECT_THROW(load_meshopt_glb(folder / "shot.glb"), std::runtime_error);
}

}  // namespace
}  // namespace flexkey::testing
