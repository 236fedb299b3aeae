// Handles as animated nodes, in files that are new and in those of a mesh.
#include "flexkey/gltf/handle_nodes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "flexkey/gltf/read_gltf.h"
#include "flexkey/gltf/write_glb.h"
#include "gltf/clips.h"
#include "gltf/glb_file.h"
#include "gltf/validate.h"
#include "support/gltf_builder.h"

namespace flexkey::testing {
namespace {

using ::testing::HasSubstr;

/// What the tip does at a frame: turns about z, grows and moves.
Eigen::Matrix4d tip_at(int frame) {
  const Vec3 pivot(1, 2, 3);
  return (Eigen::Translation3d(pivot + 0.1 * frame * Vec3::UnitX()) *
          Eigen::AngleAxisd(0.5 * frame, Vec3(1, 2, 2) / 3) * Eigen::Scaling(Vec3(1, 1 + 0.1 * frame, 1)) *
          Eigen::Translation3d(-pivot))
      .matrix();
}

std::vector<HandleTrack> base_and_tip(int frames) {
  std::vector<HandleTrack> handles = {{"base", {0, 0, 0}, {}}, {"tip", {1, 2, 3}, {}}};
  for (int k = 0; k < frames; ++k) {
    handles[0].matrices.push_back(Eigen::Matrix4d::Identity());
    handles[1].matrices.push_back(tip_at(k));
  }
  return handles;
}

/// A node's matrix from the channels of an animation, at key k of each.
Eigen::Matrix4d played(const tinygltf::Model& model, const tinygltf::Animation& animation, int node,
                       Eigen::Index k) {
  Vec3 translation = Eigen::Map<const Vec3>(model.nodes[static_cast<std::size_t>(node)].translation.data());
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Vec3 scale = Vec3::Ones();
  for (const tinygltf::AnimationChannel& channel : animation.channels) {
    if (channel.target_node != node) continue;
    const auto& sampler = animation.samplers[static_cast<std::size_t>(channel.sampler)];
    const Eigen::MatrixXd rows = rows_of(model, sampler.output);
    if (channel.target_path == "translation") translation = rows.row(k).transpose();
    if (channel.target_path == "scale") scale = rows.row(k).transpose();
    if (channel.target_path == "rotation")
      rotation = Eigen::Quaterniond(rows(k, 3), rows(k, 0), rows(k, 1), rows(k, 2));
  }
  return (Eigen::Translation3d(translation) * rotation * Eigen::Scaling(scale)).matrix();
}

/// What rests at the handle's pivot goes where the handle takes it.
Eigen::Matrix4d wanted(int frame) {
  return tip_at(frame) * Eigen::Affine3d(Eigen::Translation3d(1, 2, 3)).matrix();
}

void expect_tip(const tinygltf::Model& model, int node, std::size_t animation) {
  const std::size_t at = static_cast<std::size_t>(node);
  EXPECT_EQ(model.nodes[at].name, "tip");
  for (int k = 0; k < 20; ++k)
    EXPECT_LT((played(model, model.animations[animation], node, k) - wanted(k)).cwiseAbs().maxCoeff(), 1e-6)
        << k;
}

TEST(HandleNodes, PlayWhatTheHandlesDid) {
  const TemporaryFolder folder;
  GltfOptions options;
  options.handles = base_and_tip(20);
  write_glb(clip_of(cube(), 20, twist), options, folder / "shot.glb");
  const tinygltf::Model model = load_glb(folder / "shot.glb");
  ASSERT_EQ(model.nodes.size(), 3u);
  EXPECT_EQ(model.nodes[1].name, "base");
  EXPECT_EQ(model.scenes[0].nodes, (std::vector<int>{0, 1, 2}));
  expect_tip(model, 2, 0);
  EXPECT_EQ(model.animations[0].channels.size(), 4u) << "an anchor needs none";
  if (has_validator()) {
    const Outcome outcome = validate({folder / "shot.glb"});
    EXPECT_THAT(outcome.output, HasSubstr("0 errors, 0 warnings")) << outcome.output;
  }
}

TEST(HandleNodes, QuaternionsGoTheShortWayRound) {
  const TemporaryFolder folder;
  GltfOptions options;
  options.handles = base_and_tip(20);
  write_glb(clip_of(cube(), 20, twist), options, folder / "shot.glb");
  const tinygltf::Model model = load_glb(folder / "shot.glb");
  for (const tinygltf::AnimationChannel& channel : model.animations[0].channels) {
    if (channel.target_path != "rotation") continue;
    const Eigen::MatrixXd rows =
        rows_of(model, model.animations[0].samplers[static_cast<std::size_t>(channel.sampler)].output);
    for (Eigen::Index k = 1; k < rows.rows(); ++k) EXPECT_GT(rows.row(k).dot(rows.row(k - 1)), 0) << k;
  }
}

TEST(HandleNodes, StandInTheFileOfTheMeshToo) {
  const TemporaryFolder folder;
  const GltfFile file = read_gltf(meshes::tube_file().save(folder / "in.glb"));
  GltfOptions options;
  options.source = &file.source;
  options.handles = base_and_tip(20);
  write_glb(clip_of(file.file.mesh, 20, twist), options, folder / "out.glb");
  const tinygltf::Model model = load_glb(folder / "out.glb");
  ASSERT_EQ(model.nodes.size(), 3u);
  EXPECT_EQ(model.scenes[0].nodes, (std::vector<int>{0, 1, 2}));
  expect_tip(model, 2, 0);
}

TEST(HandleNodes, HaveNamesOfTheirOwn) {
  const TemporaryFolder folder;
  const GltfFile file = read_gltf(meshes::tube_file().save(folder / "in.glb"));
  GltfOptions options;
  options.source = &file.source;
  options.handles = base_and_tip(20);
  options.handles[0].name = "tube";
  options.handles[1].name = "tube_2";
  write_glb(clip_of(file.file.mesh, 20, twist), options, folder / "out.glb");
  const tinygltf::Model model = load_glb(folder / "out.glb");
  EXPECT_EQ(model.nodes.at(0).name, "tube");
  EXPECT_EQ(model.nodes.at(1).name, "tube_2");
  EXPECT_EQ(model.nodes.at(2).name, "tube_2_2");
}

TEST(HandleNodes, ThatNeverMoveAddNoAccessor) {
  const TemporaryFolder folder;
  GltfOptions options;
  const auto accessors_of = [&] {
    write_glb(clip_of(cube(), 20, twist), options, folder / "shot.glb");
    return load_glb(folder / "shot.glb").accessors.size();
  };
  const std::size_t without = accessors_of();
  options.handles = {base_and_tip(20).front()};
  EXPECT_EQ(accessors_of(), without);
}

TEST(HandleNodes, EveryClipPlaysItsFrames) {
  const TemporaryFolder folder;
  GltfOptions options;
  options.handles = base_and_tip(20);
  options.clips = {{"in", 0, 6.0 / 24}, {"out", 6.0 / 24, 19.0 / 24}};
  write_glb(clip_of(cube(), 20, twist), options, folder / "shot.glb");
  const tinygltf::Model model = load_glb(folder / "shot.glb");
  ASSERT_EQ(model.animations.size(), 2u);
  for (int k = 0; k <= 13; ++k)
    EXPECT_LT((played(model, model.animations[1], 2, k) - wanted(6 + k)).cwiseAbs().maxCoeff(), 1e-6) << k;
}

}  // namespace
}  // namespace flexkey::testing
