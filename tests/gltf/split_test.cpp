// Faces that never move as a mesh of their own, in files that are new.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>

#include "flexkey/gltf/read_gltf.h"
#include "flexkey/gltf/write_glb.h"
#include "flexkey/mesh/read_file.h"
#include "gltf/clips.h"
#include "gltf/expect_split.h"
#include "gltf/glb_file.h"
#include "gltf/validate.h"

namespace flexkey::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct Profile {
  const char* name;
  BasisKind basis;
  Encoding encoding;
};

void PrintTo(const Profile& profile, std::ostream* stream) {
  *stream << profile.name;
}

GltfOptions splitting(BasisKind basis = BasisKind::frames, Encoding encoding = Encoding::floats) {
  GltfOptions options;
  options.basis = basis;
  options.encoding = encoding;
  options.split = true;
  return options;
}

GltfOptions whole(GltfOptions options) {
  options.split = false;
  return options;
}

/// The sheet with a bump in a corner, in two materials of which the bump touches one, with groups and texture
/// coordinates.
Clip bumped(int frames = 12) {
  Mesh mesh = sheet(12);
  mesh.materials = {material("left"), material("right")};
  mesh.groups = {{"left", {}}, {"right", {}}};
  for (int f = 0; f < mesh.face_count(); ++f) {
    mesh.face_material.push_back(f % 12 < 6 ? 0 : 1);
    mesh.groups[f % 12 < 6 ? 0 : 1].faces.push_back(f);
  }
  unwrap_flat(mesh);
  return clip_of(mesh, frames, bump);
}

TEST(Split, WhatNeverMovesHangsOnWhatDoes) {
  const TemporaryFolder folder;
  const GltfReport report = write_glb(bumped(), splitting(), folder / "split.glb");
  const tinygltf::Model model = load_glb(folder / "split.glb");
  ASSERT_EQ(model.nodes.size(), 2u);
  EXPECT_THAT(model.scenes[0].nodes, ElementsAre(0));
  EXPECT_THAT(model.nodes[0].children, ElementsAre(1));
  EXPECT_EQ(model.nodes[0].name, "test shot");
  EXPECT_EQ(model.nodes[1].name, "test shot_still");
  const tinygltf::Mesh &moving = model.meshes.at(0), &still = model.meshes.at(1);
  EXPECT_EQ(moving.weights.size(), 12u);
  EXPECT_THAT(still.weights, IsEmpty());
  ASSERT_EQ(moving.primitives.size(), 1u) << "the bump is in one material";
  ASSERT_EQ(still.primitives.size(), 2u);
  EXPECT_EQ(moving.primitives[0].material, 0);
  EXPECT_EQ(still.primitives[1].material, 1);
  for (const tinygltf::Primitive& primitive : still.primitives) EXPECT_THAT(primitive.targets, IsEmpty());
  const auto count =
      model.accessors.at(static_cast<std::size_t>(moving.primitives[0].attributes.at("POSITION"))).count;
  EXPECT_EQ(report.target_vertices, static_cast<int>(count));
  EXPECT_LT(2 * report.target_vertices, report.vertices);
  EXPECT_EQ(report.gpu_bytes, 32u * count * 12u);
  EXPECT_EQ(report.gpu_bytes_whole, 32u * static_cast<unsigned>(report.vertices) * 12u);
  ASSERT_EQ(report.splits.size(), 1u);
  EXPECT_EQ(report.splits[0].why_whole, "");
  EXPECT_LT(report.splits[0].moved, report.splits[0].targeted) << "and border vertices, which stay";
}

class SplitProfiles : public ::testing::TestWithParam<Profile> {};

TEST_P(SplitProfiles, PlayLikeTheWholeMeshAndNeverOpen) {
  const TemporaryFolder folder;
  const GltfOptions options = splitting(GetParam().basis, GetParam().encoding);
  const Clip clip = bumped();
  const GltfReport split = write_glb(clip, options, folder / "split.glb");
  const GltfReport one = write_glb(clip, whole(options), folder / "whole.glb");
  expect_same_but_split(folder / "split.glb", folder / "whole.glb", 12, 1e-7);
  EXPECT_DOUBLE_EQ(split.error, one.error);
  EXPECT_DOUBLE_EQ(split.normal_error_largest, one.normal_error_largest);
  EXPECT_EQ(one.gpu_bytes, split.gpu_bytes_whole);
  EXPECT_THAT(one.splits, IsEmpty());
}

TEST_P(SplitProfiles, HalfOrMoreMovingChangesNoByte) {
  const TemporaryFolder folder;
  const GltfOptions options = splitting(GetParam().basis, GetParam().encoding);
  for (const auto& motion : {Motion(twist), Motion(stay)}) {
    const Clip clip = clip_of(sheet(6), 6, motion);
    const GltfReport report = write_glb(clip, options, folder / "split.glb");
    write_glb(clip, whole(options), folder / "whole.glb");
    EXPECT_EQ(read_file(folder / "split.glb"), read_file(folder / "whole.glb"));
    ASSERT_EQ(report.splits.size(), 1u);
    EXPECT_NE(report.splits[0].why_whole, "");
    EXPECT_EQ(report.gpu_bytes, report.gpu_bytes_whole);
  }
}

INSTANTIATE_TEST_SUITE_P(, SplitProfiles,
                         ::testing::Values(Profile{"compat", BasisKind::knots, Encoding::floats},
                                           Profile{"web", BasisKind::pca, Encoding::meshopt},
                                           Profile{"exact", BasisKind::frames, Encoding::floats},
                                           Profile{"frames_meshopt", BasisKind::frames, Encoding::meshopt}),
                         [](const auto& profile) { return profile.param.name; });

TEST(Split, AMeshIsOnlySplitWhereUnderHalfMoves) {
  const TemporaryFolder folder;
  const auto note_of = [&](int columns) {
    const auto lift = [&](const Vec3& p, int frame) -> Vec3 {
      return p.x() < (columns - 0.5) / 3 ? p + Vec3(0, 0, 0.1 * frame) : p;
    };
    GltfOptions options = splitting();
    options.normals = false;
    return write_glb(clip_of(sheet(3), 3, lift), options, folder / "split.glb").splits.at(0);
  };
  EXPECT_EQ(note_of(1).why_whole, "") << "4 of 16 vertices";
  EXPECT_EQ(note_of(1).targeted, 8);
  EXPECT_EQ(note_of(2).why_whole, "8 of its 16 vertices move");
  EXPECT_EQ(note_of(0).why_whole, "nothing moves");
}

TEST(Split, WhereEveryFaceMovesThereIsNothingToSplit) {
  const TemporaryFolder folder;
  const auto lift = [](const Vec3& p, int frame) -> Vec3 {
    const bool is_on_diagonal = std::abs(p.x() + p.y() - 1) < 0.1;
    return is_on_diagonal ? p + Vec3(0, 0, 0.1 * frame) : p;
  };
  GltfOptions options = splitting();
  options.normals = false;
  const Clip clip = clip_of(sheet(2), 3, lift);
  const SplitNote note = write_glb(clip, options, folder / "split.glb").splits.at(0);
  EXPECT_EQ(note.moved, 3);
  EXPECT_EQ(note.targeted, 9);
  EXPECT_EQ(note.why_whole, "faces that move name all of its vertices");
}

TEST(Split, GroupsKeepTheirFaces) {
  const TemporaryFolder folder;
  write_glb(bumped(), splitting(), folder / "split.glb");
  const Mesh mesh = read_gltf(folder / "split.glb").file.mesh;
  std::map<std::string, std::size_t> sizes;
  std::map<std::string, double> lowest, highest;
  for (const Group& group : mesh.groups) {
    sizes[group.name] = group.faces.size();
    for (const int face : group.faces)
      for (const int v : mesh.face(face)) {
        double& low = lowest.try_emplace(group.name, 1).first->second;
        low = std::min(low, mesh.positions(v, 0));
        highest[group.name] = std::max(highest[group.name], mesh.positions(v, 0));
      }
  }
  EXPECT_EQ(highest["left"], 0.5);
  EXPECT_EQ(lowest["right"], 0.5);
  EXPECT_EQ(sizes["left"], 144u);
  EXPECT_EQ(sizes["right"], 144u);
}

TEST(Split, TheValidatorFindsNoError) {
  if (!has_validator()) GTEST_SKIP() << "glTF-Validator is not installed: run `npm ci` in " VALIDATE_FOLDER;
  const TemporaryFolder folder;
  write_glb(bumped(), splitting(), folder / "exact.glb");
  write_glb(bumped(), splitting(BasisKind::knots), folder / "compat.glb");
  write_glb(bumped(), splitting(BasisKind::pca, Encoding::meshopt), folder / "web.glb");
  const Outcome outcome = validate({folder / "exact.glb", folder / "compat.glb", folder / "web.glb"});
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  for (const char* name : {"exact", "compat", "web"})
    EXPECT_THAT(outcome.output, ::testing::HasSubstr(std::string(name) + ".glb: 0 errors, 0 warnings"));
}

}  // namespace
}  // namespace flexkey::testing
