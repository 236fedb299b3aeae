// Motions of nodes, read back from files.
#include "flexkey/gltf/node_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "flexkey/gltf/write_glb.h"
#include "gltf/clips.h"

namespace flexkey::testing {
namespace {

const Vec3 pivot(1, 2, 3);

/// A clip with a handle 'tip' that turns by 0.2 a frame about z and moves along x.
std::filesystem::path file_with_tip(const TemporaryFolder& folder, int frames) {
  GltfOptions options;
  HandleTrack tip{"tip", pivot, {}};
  for (int k = 0; k < frames; ++k)
    tip.matrices.push_back((Eigen::Translation3d(pivot + 0.1 * k * Vec3::UnitX()) *
                            Eigen::AngleAxisd(0.2 * k, Vec3::UnitZ()) * Eigen::Translation3d(-pivot))
                               .matrix());
  options.handles = {tip};
  write_glb(clip_of(cube(), frames, twist), options, folder / "shot.glb");
  return folder / "shot.glb";
}

/// The sample nearest to a time.
NodeSample at(const std::vector<NodeSample>& samples, double time) {
  return *std::min_element(samples.begin(), samples.end(), [&](const NodeSample& a, const NodeSample& b) {
    return std::abs(a.time - time) < std::abs(b.time - time);
  });
}

TEST(NodeMotion, OfAHandleThatWasWrittenIsWhatItDid) {
  const TemporaryFolder folder;
  const std::vector<NodeSample> samples = read_node_motion(file_with_tip(folder, 20), "tip");
  const double fps = clip_of(cube(), 2, twist).fps;
  for (int k = 0; k < 20; ++k) {
    const NodeSample sample = at(samples, k / fps);
    EXPECT_NEAR(sample.time, k / fps, 1e-6);
    EXPECT_LT((sample.translation - (pivot + 0.1 * k * Vec3::UnitX())).norm(), 1e-5) << k;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.2 * k, Vec3::UnitZ()));
    EXPECT_LT(sample.rotation.angularDistance(turn), 1e-5) << k;
    EXPECT_LT((sample.scale - Vec3::Ones()).norm(), 1e-5) << k;
  }
  for (std::size_t k = 1; k < samples.size(); ++k) {
    EXPECT_GT(samples[k].time, samples[k - 1].time);
    EXPECT_LT(samples[k].time - samples[k - 1].time, 1.01 / 60);
  }
}

TEST(NodeMotion, WhatIsNotThereIsNamed) {
  const TemporaryFolder folder;
  const std::filesystem::path file = file_with_tip(folder, 3);
  const auto message = [&](const std::string& node) -> std::string {
    try {
      read_node_motion(file, node);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_THAT(message("tipp"), ::testing::HasSubstr("no node 'tipp' in shot.glb; did you mean 'tip'?"));
  EXPECT_THAT(message(clip_of(cube(), 2, twist).name), ::testing::HasSubstr("no animation moves node"));
}

}  // namespace
}  // namespace flexkey::testing
