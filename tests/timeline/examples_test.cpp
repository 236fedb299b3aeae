// The three examples of the timeline's documentation, value by value.
#include <gtest/gtest.h>

#include <numbers>
#include <variant>

#include "timeline/parsing.h"

namespace flexkey {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Examples, Smallest) {
  const Shot shot = parse(R"(mesh: meshes/bar.obj
handles:
  base: {select: {axis: z, below: 1%}}          # no motion: an anchor, held at rest
  tip:
    select: {axis: z, above: 99%}
    rotate: {axis: z, keys: {0s: 0deg, 2s: 90deg}}
output: bar.glb
)");
  EXPECT_EQ(shot.name, "shot");
  EXPECT_EQ(shot.file, "shot.yaml");
  EXPECT_EQ(shot.mesh.file, "meshes/bar.obj");
  EXPECT_EQ(shot.mesh.where.line, 1);
  EXPECT_EQ(shot.mesh.where.column, 7);
  EXPECT_EQ(shot.fps, 24);
  EXPECT_EQ(shot.duration, 2);
  EXPECT_EQ(shot.frame_count(), 49);
  EXPECT_EQ(shot.gltf.path, "bar.glb");
  EXPECT_TRUE(shot.gltf.normals);
  EXPECT_FALSE(shot.roi);
  ASSERT_EQ(shot.lambda.size(), 1u);
  EXPECT_EQ(shot.lambda[0].value, 0.5);

  ASSERT_EQ(shot.handles.size(), 2u);
  const Handle &base = shot.handles[0], &tip = shot.handles[1];
  EXPECT_EQ(base.name, "base");
  EXPECT_TRUE(base.is_anchor());
  const auto& below = std::get<SelectAxis>(base.select.kind);
  EXPECT_EQ(below.axis, 2);
  EXPECT_FALSE(below.above);
  EXPECT_EQ(below.below->value, 0.01);
  EXPECT_TRUE(below.below->is_share);
  EXPECT_EQ(base.select.where.line, 3);
  EXPECT_EQ(base.select.where.column, 25);

  EXPECT_EQ(tip.name, "tip");
  EXPECT_EQ(tip.where.line, 4);
  EXPECT_EQ(tip.where.column, 3);
  EXPECT_FALSE(tip.is_anchor());
  ASSERT_EQ(tip.rotate.size(), 2u);
  EXPECT_EQ(tip.rotate[1].time, 2);
  EXPECT_EQ(tip.rotate[1].value.axis, Vec3::UnitZ());
  EXPECT_DOUBLE_EQ(tip.rotate[1].value.angle, pi / 2);
}

TEST(Examples, NosePulledAlongACurve) {
  const Shot shot = parse(R"(mesh: meshes/head.obj
points: {bridge: [0, 0.45, 0.86], tip: [0, 0.12, 1.05]}
roi: {geodesic: {from: tip, radius: 30%}}
handles:
  ridge:
    select: {path: [bridge, tip]}
    curve:
      keys:
        0s: rest
        2s: {bezier: [bridge, [0, 0.5, 1.2], [0, 0.25, 1.4], [0, 0.1, 1.35]]}
      ease: ease-out
lambda: {2s: 0, 3s: 0.2, 4s: 0.5, 6s: 1}
output: {gltf: nose.glb, preview: {camera: {look_at: tip, azimuth: 60deg}, contact_sheet: {at: [2s, 3s, 4s, 6s]}}}
)");
  ASSERT_TRUE(shot.roi);
  const auto& roi = std::get<SelectGeodesic>(shot.roi->kind);
  EXPECT_EQ(roi.from, Vec3(0, 0.12, 1.05));
  EXPECT_TRUE(roi.radius.is_share);
  EXPECT_DOUBLE_EQ(roi.radius.value, 0.3);

  const Handle& ridge = shot.handles.at(0);
  const auto& path = std::get<SelectPath>(ridge.select.kind);
  ASSERT_EQ(path.points.size(), 2u);
  EXPECT_EQ(path.points[0], Vec3(0, 0.45, 0.86));
  ASSERT_EQ(ridge.curve.size(), 2u);
  EXPECT_EQ(ridge.curve[0].value.kind, Curve::Kind::rest);
  EXPECT_EQ(ridge.curve[1].value.kind, Curve::Kind::bezier);
  ASSERT_EQ(ridge.curve[1].value.points.size(), 4u);
  EXPECT_EQ(ridge.curve[1].value.points[0], Vec3(0, 0.45, 0.86));
  EXPECT_EQ(ridge.curve[0].ease.kind, Easing::Kind::bezier);
  EXPECT_EQ(ridge.curve[0].ease.x2, 0.58);

  ASSERT_EQ(shot.lambda.size(), 4u);
  EXPECT_EQ(shot.lambda[1].time, 3);
  EXPECT_EQ(shot.lambda[1].value, 0.2);
  EXPECT_EQ(shot.duration, 6) << "the last key of any track, here of lambda";
  EXPECT_EQ(shot.gltf.path, "nose.glb");
  EXPECT_EQ(shot.preview.camera.look_at, Vec3(0, 0.12, 1.05));
  EXPECT_DOUBLE_EQ(shot.preview.camera.azimuth, pi / 3);
  EXPECT_EQ(shot.preview.sheet.at.size(), 4u);
}

TEST(Examples, BarTwistedTwiceAndBack) {
  const Shot shot = parse(R"(mesh: meshes/bar_20.obj
lambda: 1
ease: ease-in-out
handles:
  base: {select: {axis: z, below: 1%}}
  top:
    select: {axis: z, above: 99%}
    rotate: {axis: z, keys: {0s: 0deg, 3s: 720deg, 4s: 720deg, 6s: 360deg}}
    move: {keys: {4s: [0, 0, 0], 6s: [0, 0, 2]}}
output: {gltf: {path: bar.glb, profile: compat, tolerance: 0.1%}, preview: {dir: bar/, size: [960, 540], subdivide: 1}}
)");
  ASSERT_EQ(shot.lambda.size(), 1u);
  EXPECT_EQ(shot.lambda[0].value, 1);
  const Handle& top = shot.handles.at(1);
  ASSERT_EQ(top.rotate.size(), 4u);
  EXPECT_DOUBLE_EQ(top.rotate[1].value.angle, 4 * pi) << "two turns stay two turns";
  EXPECT_EQ(top.rotate[0].ease.kind, Easing::Kind::bezier) << "the file's default easing";
  EXPECT_EQ(top.rotate[0].ease.x1, 0.42);
  ASSERT_EQ(top.move.size(), 2u);
  EXPECT_EQ(top.move[1].value, Vec3(0, 0, 2));
  EXPECT_EQ(shot.gltf.path, "bar.glb");
  EXPECT_EQ(shot.preview.dir, "bar/");
  EXPECT_EQ(shot.preview.subdivide, 1);
}

}  // namespace
}  // namespace flexkey
