#include "flexkey/gltf/size_estimate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "flexkey/gltf/basis.h"
#include "flexkey/gltf/write_glb.h"
#include "flexkey/mesh/error.h"
#include "gltf/clips.h"

namespace flexkey::testing {
namespace {

struct Sizes {
  double estimated, actual;  // bytes
};

GlbContents contents_of(const Clip& clip, const GltfOptions& options) {
  const Asset asset = asset_of(clip, options);
  std::vector<int> numbers(clip.frames.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  MorphTargets targets{frame_basis({clip.frames, clip.mesh.positions, numbers}).targets, {}};
  for (const Positions& frame : clip.frames) {
    if (!asset.normals) break;
    targets.normals.emplace_back(asset.normals->at(frame).cast<float>() - asset.rest.normals);
  }
  return count_contents(asset, targets);
}

Sizes sizes_of(const Clip& clip, bool normals) {
  const TemporaryFolder folder;
  GltfOptions options = exact();
  options.normals = normals;
  const GlbContents contents = contents_of(clip, options);
  const GltfReport report = write_glb(clip, options, folder / "shot.glb");
  EXPECT_EQ(report.bytes, std::filesystem::file_size(folder / "shot.glb"));
  return {static_cast<double>(estimate_glb_bytes(contents)), static_cast<double>(report.bytes)};
}

TEST(SizeEstimate, IsAboveTheFileAndNotFarAbove) {
  for (const bool normals : {true, false}) {
    for (const Motion& motion : {Motion(twist), Motion(bump), Motion(stay)}) {
      const auto [estimated, actual] = sizes_of(clip_of(sheet(20), 20, motion), normals);
      EXPECT_GE(estimated, actual);
      EXPECT_LT(estimated, 1.4 * actual + 60'000);
    }
  }
}

TEST(SizeEstimate, CountsVerticesThatMoveAndTheirNeighbours) {
  Mesh mesh = sheet(10);
  const Clip clip = clip_of(mesh, 3, [](const Vec3& p, int k) {
    return k == 2 && p.x() > 0.95 && p.y() > 0.95 ? Vec3(p + Vec3(0, 0, 1)) : p;
  });
  const GlbContents contents = contents_of(clip, exact());
  EXPECT_EQ(contents.vertices, 121);
  EXPECT_EQ(contents.triangles, 200);
  EXPECT_EQ(contents.frames, 3);
  EXPECT_EQ(contents.moved, 1);
  EXPECT_EQ(contents.turned, 4);
}

GlbContents many(std::int64_t vertices, std::int64_t frames, std::int64_t moved) {
  GlbContents contents;
  contents.frames = contents.targets = frames;
  contents.primitives = 1;
  contents.vertices = vertices;
  contents.triangles = 2 * vertices;
  contents.moved = contents.turned = moved * frames;
  contents.normals = true;
  return contents;
}

TEST(SizeEstimate, RefusesFourGibibytesByArithmetic) {
  EXPECT_NO_THROW(check_glb_size(many(1'000'000, 170, 1'000'000)));
  try {
    check_glb_size(many(1'000'000, 200, 1'000'000));
    FAIL() << "4.5 GiB were taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                ::testing::StartsWith("the GLB would take about 4.5 GiB, and a GLB cannot reach 4 GiB"));
  }
}

TEST(SizeEstimate, ALargeMeshOfWhichLittleMovesIsTaken) {
  EXPECT_NO_THROW(check_glb_size(many(1'000'000, 200, 50'000)));
}

TEST(SizeEstimate, DoesNotOverflow) {
  const std::int64_t bytes = estimate_glb_bytes(many(2'000'000'000, 65'535, 2'000'000'000));
  EXPECT_GT(bytes, std::int64_t{3'000'000'000'000'000});
}

}  // namespace
}  // namespace flexkey::testing
