// What each profile plays, by a reader of the tests' own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <ostream>

#include "flexkey/gltf/primitives.h"
#include "flexkey/gltf/write_glb.h"
#include "flexkey/mesh/error.h"
#include "gltf/clips.h"
#include "gltf/glb_file.h"
#include "gltf/meshopt_file.h"

namespace flexkey::testing {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;

struct Choice {
  std::string name;
  BasisKind basis;
  Encoding encoding;
};

void PrintTo(const Choice& choice, std::ostream* stream) {
  *stream << choice.name;
}

const std::vector<Choice> choices = {{"compat", BasisKind::knots, Encoding::floats},
                                     {"web", BasisKind::pca, Encoding::meshopt},
                                     {"pca float", BasisKind::pca, Encoding::floats},
                                     {"knots meshopt", BasisKind::knots, Encoding::meshopt},
                                     {"frames meshopt", BasisKind::frames, Encoding::meshopt},
                                     {"exact", BasisKind::frames, Encoding::floats}};

/// A sheet that curls up and comes back with an ease.
Clip curl(int frames) {
  return clip_of(sheet(20), frames, [frames](const Vec3& p, int k) {
    const double share = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * k / (frames - 1));
    const double angle = 1.5 * share * p.x() + 1e-9;
    return Vec3(p.x() * std::sin(angle) / angle, p.y() * (1 - 0.1 * share),
                p.x() * (1 - std::cos(angle)) / angle);
  });
}

class Profiles : public ::testing::TestWithParam<Choice> {
 protected:
  GltfOptions options(double tolerance) const {
    GltfOptions options;
    options.basis = GetParam().basis;
    options.encoding = GetParam().encoding;
    options.tolerance = tolerance;
    return options;
  }

  GltfReport write(const Clip& clip, double tolerance = 1e-3) {
    const GltfReport report = write_glb(clip, options(tolerance), folder_ / "shot.glb");
    model_ = load_meshopt_glb(folder_ / "shot.glb");
    return report;
  }

  /// The farthest that a vertex plays from the clip at a frame, which may lie between two.
  double error(const Clip& clip, double frame) const {
    const Primitive primitive = split_primitives(clip.mesh)[0];
    const auto before = static_cast<std::size_t>(frame);
    const std::size_t after = std::min(before + 1, clip.frames.size() - 1);
    const double share = frame - static_cast<double>(before);
    const Positions solved = (1 - share) * clip.frames[before] + share * clip.frames[after];
    const Eigen::MatrixXd played =
        morphed(model_, 0, "POSITION", weights_at(model_, static_cast<float>(frame / clip.fps)))
            .cast<double>();
    return (played - solved(primitive.vertices, Eigen::all)).rowwise().norm().maxCoeff() /
           bounds_of(clip.mesh.positions).diagonal();
  }

  TemporaryFolder folder_;
  tinygltf::Model model_;
};

TEST_P(Profiles, PlayWithinTheToleranceAtFramesAndBetween) {
  const Clip clip = curl(49);
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    const GltfReport report = write(clip, tolerance);
    double largest = 0;
    for (double frame = 0; frame <= 48; frame += 0.125) largest = std::max(largest, error(clip, frame));
    EXPECT_LE(largest, tolerance + 1e-6);  // times are floats too
    EXPECT_LE(largest, report.error + 1e-6);
    EXPECT_EQ(report.profile, GetParam().name);
    EXPECT_TRUE(report.warnings.empty());
  }
}

TEST_P(Profiles, TakeFarFewerTargetsThanFrames) {
  const GltfReport report = write(curl(49));
  EXPECT_EQ(report.targets, static_cast<int>(model_.meshes[0].primitives[0].targets.size()));
  if (GetParam().basis == BasisKind::frames) {
    EXPECT_EQ(report.targets, 49);
  } else {
    EXPECT_LE(report.targets, 12);
  }
  EXPECT_EQ(report.gpu_bytes, 32u * 441u * static_cast<unsigned>(report.targets));
}

TEST_P(Profiles, KeepNormalsWithinADegreeOnAverage) {
  const GltfReport report = write(curl(49));
  EXPECT_LT(report.normal_error_mean, 1);
  EXPECT_LT(report.normal_error_mean, report.normal_error_largest + 1e-12);
}

TEST_P(Profiles, AStillClipHasATargetThatMovesNothing) {
  const Clip clip = clip_of(sheet(3), 5, stay);
  write(clip);
  EXPECT_GE(model_.meshes[0].primitives[0].targets.size(), 1u);
  const double most = GetParam().encoding == Encoding::meshopt ? 1e-4 : 1e-7;  // its base is on a grid
  for (const double frame : {0.0, 2.5, 4.0}) EXPECT_LT(error(clip, frame), most);
}

TEST_P(Profiles, OneFrameIsAWholeClip) {
  const Clip clip = clip_of(sheet(6), 1, [](const Vec3& p, int) { return twist(p, 5); });
  write(clip);
  EXPECT_LE(error(clip, 0), 1e-3);
}

TEST_P(Profiles, WithoutNormalsHaveNone) {
  GltfOptions flat = options(1e-3);
  flat.normals = false;
  write_glb(curl(20), flat, folder_ / "shot.glb");
  const tinygltf::Primitive primitive = load_meshopt_glb(folder_ / "shot.glb").meshes[0].primitives[0];
  EXPECT_FALSE(primitive.attributes.contains("NORMAL"));
  for (const auto& target : primitive.targets) EXPECT_EQ(target.size(), 1u);
}

TEST_P(Profiles, SayWhatTheyAre) {
  const Clip clip = curl(20);
  const GltfReport report = write(clip);
  for (const tinygltf::Value& extras : {model_.meshes[0].extras, model_.animations[0].extras}) {
    EXPECT_EQ(extras.Get("profile").Get<std::string>(), GetParam().name);
    EXPECT_EQ(extras.Get("error").GetNumberAsDouble(), report.error);
    EXPECT_EQ(extras.Has("tolerance"), GetParam().basis != BasisKind::frames);
  }
  EXPECT_EQ(model_.meshes[0].extras.Get("targetNames").ArrayLen(), model_.meshes[0].weights.size());
}

TEST_P(Profiles, TellHowMuchIsDone) {
  GltfOptions told = options(1e-3);
  std::vector<double> shares;
  told.on_progress = [&](double share) { shares.push_back(share); };
  write_glb(curl(20), told, folder_ / "shot.glb");
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  ASSERT_GE(shares.size(), 60u);
  EXPECT_EQ(shares.back(), 1);
}

INSTANTIATE_TEST_SUITE_P(All, Profiles, ::testing::ValuesIn(choices), [](const auto& choice) {
  std::string name = choice.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

TEST(FloatProfiles, HaveWeightsThatNoClientClamps) {
  const TemporaryFolder folder;
  for (const BasisKind basis : {BasisKind::knots, BasisKind::pca, BasisKind::frames}) {
    GltfOptions options;
    options.basis = basis;
    write_glb(curl(49), options, folder / "shot.glb");
    const tinygltf::Model model = load_glb(folder / "shot.glb");
    const Eigen::MatrixXd weights = rows_of(model, model.animations[0].samplers[0].output);
    EXPECT_GE(weights.minCoeff(), 0);
    EXPECT_LE(weights.maxCoeff(), 1);
  }
}

TEST(Compat, AtMostTwoTargetsPlayAtATime) {
  const TemporaryFolder folder;
  write_glb(curl(49), {}, folder / "shot.glb");
  const tinygltf::Model model = load_glb(folder / "shot.glb");
  for (float frame = 0; frame <= 48; frame += 0.25F) {
    const std::vector<float> weights = weights_at(model, frame / 24);
    EXPECT_LE(std::count_if(weights.begin(), weights.end(), [](float w) { return w != 0; }), 2) << frame;
  }
}

TEST(Compat, ComesBackByTheSameTargets) {
  const TemporaryFolder folder;
  const Clip whole = curl(49);
  Clip half = whole;
  half.frames.resize(25);
  half.reports.resize(25);
  const int there = write_glb(half, {}, folder / "half.glb").targets;
  EXPECT_LE(write_glb(whole, {}, folder / "whole.glb").targets, there + 1);
}

TEST(Compat, MoreTargetsThanAllowedAreAnErrorThatSaysWhatHelps) {
  const TemporaryFolder folder;
  GltfOptions options;
  options.max_targets = 2;
  options.tolerance = 1e-6;
  try {
    write_glb(curl(49), options, folder / "shot.glb");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("at most 2 are allowed (max_targets)"));
    EXPECT_THAT(error.what(), HasSubstr("A larger tolerance"));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Compatibility, TellsWhoPlaysAFile) {
  for (const ClientNote& note : client_notes(40, false)) EXPECT_TRUE(note.plays) << note.client;
  for (const ClientNote& note : client_notes(40, true))
    EXPECT_EQ(note.plays, note.client != "Blender" && note.client != "Godot") << note.client;
  for (const ClientNote& note : client_notes(257, false))
    EXPECT_EQ(note.plays, note.client == "Blender" || note.client == "Godot") << note.client;
}

}  // namespace
}  // namespace flexkey::testing
