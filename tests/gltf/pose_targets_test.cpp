// Poses as named morph targets beside those of the clip.
#include "flexkey/gltf/pose_targets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "flexkey/gltf/gltf_scene.h"
#include "flexkey/gltf/read_accessor.h"
#include "flexkey/gltf/read_gltf.h"
#include "flexkey/mesh/error.h"
#include "gltf/clips.h"
#include "gltf/validate.h"
#include "support/gltf_builder.h"

namespace flexkey::testing {
namespace {

using json = nlohmann::json;
using meshes::GltfBuilder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Vec3 swell(const Vec3& p, int) {
  return p + 0.2 * Vec3(p.x(), p.y(), 0);
}

/// Lifts the corner x, y < 0.3 of the sheet or of what is like it.
Vec3 lift(const Vec3& p, int) {
  return p + Vec3(0, 0, p.x() < 0.3 && p.y() < 0.3 ? 0.5 : 0);
}

PoseShape pose_of(const std::string& name, const Mesh& mesh, const Motion& motion) {
  return {name, clip_of(mesh, 1, motion).frames[0]};
}

GltfOptions profile(BasisKind basis, Encoding encoding) {
  GltfOptions options;
  options.basis = basis;
  options.encoding = encoding;
  return options;
}

/// A written file as clients have it.
class Written {
 public:
  explicit Written(const std::filesystem::path& path)
      : file_(read_gltf(path)),
        scene_(parse_gltf_scene(file_.source.document.json)),
        root_(json::parse(file_.source.document.json)),
        reader_(scene_, file_.source.document.bytes) {}

  const json& root() const { return root_; }
  std::size_t target_count(const SolvedNode& node) const { return primitive_of(node, 0).targets.size(); }

  /// The farthest that any vertex of the meshes with targets is from the pose, with the target that is
  /// `from_last` before the last at 1 and no other. Vertices are told by their places at rest.
  double distance(const Mesh& mesh, const PoseShape& pose, std::size_t from_last) const {
    double largest = 0;
    for (const SolvedNode& node : file_.source.nodes)
      for (std::size_t p = 0; p < node.primitives.size(); ++p) {
        const GltfPrimitive& primitive = primitive_of(node, p);
        if (primitive.targets.empty()) continue;
        const auto& target = primitive.targets[primitive.targets.size() - 1 - from_last];
        const Positions rest = reader_.rows(primitive.attributes.at("POSITION"), 3);
        const Positions posed = rest + Positions(reader_.rows(target.at("POSITION"), 3));
        const Eigen::Matrix3d linear = node.world.topLeftCorner<3, 3>();
        const Eigen::RowVector3d offset = node.world.topRightCorner<3, 1>().transpose();
        for (Eigen::Index row = 0; row < rest.rows(); ++row) {
          Eigen::Index v = 0;
          const Eigen::RowVector3d place = rest.row(row) * linear.transpose() + offset;
          (mesh.positions.rowwise() - place).rowwise().norm().minCoeff(&v);
          const Eigen::RowVector3d shown = posed.row(row) * linear.transpose() + offset;
          largest = std::max(largest, (shown - pose.positions.row(v)).norm());
        }
      }
    return largest;
  }

  /// Whether all animations of the file give the last `count` targets of their mesh no weight.
  void expect_unplayed(std::size_t count) const {
    for (const GltfAnimation& animation : scene_.animations)
      for (const GltfWeightsChannel& channel : animation.weights) {
        const GltfSampler& sampler = animation.samplers[static_cast<std::size_t>(channel.sampler)];
        const auto& mesh =
            scene_
                .meshes[static_cast<std::size_t>(scene_.nodes[static_cast<std::size_t>(channel.node)].mesh)];
        const auto targets = static_cast<Eigen::Index>(mesh.primitives[0].targets.size());
        const AccessorRows values = reader_.rows(sampler.output, 1);
        const Eigen::Index keys = reader_.rows(sampler.input, 1).rows();
        ASSERT_EQ(values.rows(), keys * targets);
        for (Eigen::Index key = 0; key < keys; ++key)
          EXPECT_TRUE(values
                          .middleRows((key + 1) * targets - static_cast<Eigen::Index>(count),
                                      static_cast<Eigen::Index>(count))
                          .isZero(0));
      }
  }

 private:
  const GltfPrimitive& primitive_of(const SolvedNode& node, std::size_t p) const {
    return scene_.meshes[static_cast<std::size_t>(node.mesh)].primitives[p];
  }

  GltfFile file_;
  GltfScene scene_;
  json root_;
  AccessorReader reader_;
};

TEST(PoseTargets, EveryProfileShowsThemAtAWeightOfOne) {
  const TemporaryFolder folder;
  const Clip clip = clip_of(cube(), 12, twist);
  const double tolerance = 1e-3 * bounds_of(clip.mesh.positions).diagonal();
  for (const BasisKind basis : {BasisKind::knots, BasisKind::pca, BasisKind::frames})
    for (const Encoding encoding : {Encoding::floats, Encoding::meshopt}) {
      GltfOptions options = profile(basis, encoding);
      options.poses = {pose_of("swollen", clip.mesh, swell), pose_of("lifted", clip.mesh, lift)};
      const GltfReport report = write_glb(clip, options, folder / "out.glb");
      const Written written(folder / "out.glb");
      const json& mesh = written.root()["meshes"][0];
      const json& names = mesh["extras"]["targetNames"];
      ASSERT_EQ(names.size(), static_cast<std::size_t>(report.targets));
      EXPECT_EQ(names[names.size() - 2], "swollen");
      EXPECT_EQ(names[names.size() - 1], "lifted");
      EXPECT_EQ(mesh["weights"], json(std::vector<double>(names.size(), 0)));
      EXPECT_LT(written.distance(clip.mesh, options.poses[0], 1), tolerance);
      EXPECT_LT(written.distance(clip.mesh, options.poses[1], 0), tolerance);
      EXPECT_LT(report.pose_error, 1e-3);
      EXPECT_LT(report.error, 1e-3) << "the clip plays as without them";
      written.expect_unplayed(2);
    }
}

TEST(PoseTargets, GoIntoTheFileOfTheMesh) {
  const TemporaryFolder folder;
  for (const GltfBuilder& builder : {meshes::tube_file(), meshes::tube_with_targets(), meshes::two_tubes()})
    for (const Encoding encoding : {Encoding::floats, Encoding::meshopt}) {
      const GltfFile file = read_gltf(builder.save(folder / "in.glb"));
      const Clip clip = clip_of(file.file.mesh, 6, twist);
      GltfOptions options = profile(BasisKind::knots, encoding);
      options.source = &file.source;
      options.poses = {pose_of("smile", clip.mesh, swell), pose_of("flat", clip.mesh, bump)};
      const GltfReport report = write_glb(clip, options, folder / "out.glb");
      EXPECT_LT(report.pose_error, 1e-3);
      const Written written(folder / "out.glb");
      const double tolerance = 1e-3 * bounds_of(clip.mesh.positions).diagonal();
      EXPECT_LT(written.distance(clip.mesh, options.poses[0], 1), tolerance);
      EXPECT_LT(written.distance(clip.mesh, options.poses[1], 0), tolerance);
      written.expect_unplayed(2);
      const json& names = written.root()["meshes"][0]["extras"]["targetNames"];
      const bool has_smile = std::find(names.begin(), names.end() - 2, "smile") != names.end() - 2;
      EXPECT_EQ(names[names.size() - 2], has_smile ? "smile_2" : "smile");
    }
}

TEST(PoseTargets, WhatOnlyAPoseMovesIsNotSplitOff) {
  const TemporaryFolder folder;
  const Clip clip = clip_of(sheet(20), 6, bump);
  GltfOptions options;
  options.split = true;
  options.poses = {pose_of("lifted", clip.mesh, lift)};
  GltfReport report = write_glb(clip, options, folder / "out.glb");
  EXPECT_LT(report.gpu_bytes, report.gpu_bytes_whole) << "most of the sheet stays";
  EXPECT_LT(Written(folder / "out.glb").distance(clip.mesh, options.poses[0], 0), 1e-3);
  options.poses.push_back(pose_of("swollen", clip.mesh, swell));
  report = write_glb(clip, options, folder / "out.glb");
  EXPECT_EQ(report.gpu_bytes, report.gpu_bytes_whole);
}

TEST(PoseTargets, AClipThatStaysMayHaveThemAlone) {
  const TemporaryFolder folder;
  const Clip clip = clip_of(cube(), 3, stay);
  GltfOptions options;
  options.poses = {pose_of("swollen", clip.mesh, swell)};
  EXPECT_EQ(write_glb(clip, options, folder / "out.glb").targets, 1);
  EXPECT_THAT(Written(folder / "out.glb").root()["meshes"][0]["extras"]["targetNames"],
              ElementsAre("swollen"));
}

TEST(PoseTargets, CountAmongThoseThatAreAllowed) {
  const Clip clip = clip_of(cube(), 4, twist);
  GltfOptions options = exact();
  options.poses = {pose_of("f0001", clip.mesh, swell), pose_of("b", clip.mesh, lift)};
  options.max_targets = 6;
  EXPECT_EQ(make_glb(clip, options).report.targets, 6);
  options.max_targets = 5;
  EXPECT_THROW(make_glb(clip, options), InputError);
}

TEST(PoseTargets, OnesThatDoNotFitAreAnError) {
  const Clip clip = clip_of(cube(), 2, twist);
  GltfOptions options;
  options.poses = {pose_of("other", sheet(1), stay)};
  try {
    make_glb(clip, options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("pose 'other' has 4 vertices, the mesh has 8"));
  }
}

TEST(PoseTargets, TheValidatorFindsNoError) {
  if (!has_validator()) GTEST_SKIP() << "glTF-Validator is not installed: run `npm ci` in " VALIDATE_FOLDER;
  const TemporaryFolder folder;
  std::vector<std::filesystem::path> files;
  const auto next = [&] {
    files.push_back(folder / std::to_string(files.size()).append(".glb"));
    return files.back();
  };
  for (const Encoding encoding : {Encoding::floats, Encoding::meshopt}) {
    for (const bool split : {false, true}) {
      const Clip clip = clip_of(sheet(20), 6, bump);
      GltfOptions options = profile(BasisKind::knots, encoding);
      options.split = split;
      options.poses = {pose_of("a", clip.mesh, lift), pose_of("rest", clip.mesh, stay)};
      write_glb(clip, options, next());
    }
    for (const GltfBuilder& builder :
         {meshes::tube_with_targets(), meshes::two_tubes(), meshes::skinned_tube()}) {
      const GltfFile file = read_gltf(builder.save(folder / "in.glb"));
      const Clip clip = clip_of(file.file.mesh, 6, twist);
      GltfOptions options = profile(BasisKind::pca, encoding);
      options.source = &file.source;
      options.poses = {pose_of("smile", clip.mesh, swell)};
      write_glb(clip, options, next());
    }
  }
  const Outcome outcome = validate(files);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
}

}  // namespace
}  // namespace flexkey::testing
