// Vertices that are not solved and ride on the surface.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "animate/shots.h"
#include "flexkey/animate/animate.h"

namespace flexkey {
namespace {

using test::shot_of;

/// A bar and a small one that floats beside its top.
Mesh bar_with_button() {
  Mesh button = meshes::bar(1, 1, 1);
  button.positions *= 0.25;
  button.positions.rowwise() += Eigen::RowVector3d(2.25, 1, 7);
  return meshes::joined(meshes::bar(2, 2, 8), button);
}

const std::string tip =
    "  tip: {select: {all: [{component: 0}, {axis: z, above: 6}]}, pivot: [1, 1, 7], rotate: {axis: x, keys: "
    "{0s: 0deg, 0.25s: "
    "50deg}}}\n";

/// The largest distance of the button's vertices from where a motion takes them.
double off(const Mesh& mesh, const Positions& posed, const Eigen::Affine3d& motion) {
  double largest = 0;
  for (int v = meshes::bar(2, 2, 8).vertex_count(); v < mesh.vertex_count(); ++v)
    largest = std::max(largest,
                       (posed.row(v).transpose() - motion * Vec3(mesh.positions.row(v).transpose())).norm());
  return largest;
}

TEST(Attach, RidesOnTheNearestCell) {
  const Mesh mesh = bar_with_button();
  const Clip clip = animate(shot_of(test::held_bar + tip + "attach: [{select: {component: 1}}]\n"), mesh);
  const Eigen::AngleAxisd turn(50 * std::numbers::pi / 180, Vec3::UnitX());
  const Vec3 pivot(1, 1, 7);
  const Eigen::Affine3d motion = Eigen::Translation3d(pivot) * turn * Eigen::Translation3d(-pivot);
  EXPECT_LT(off(mesh, clip.frames.back(), motion), 1e-6) << "beside a part that turns as one body";
}

TEST(Attach, MayRideOnAPartThatIsNotTheNearest) {
  const Mesh mesh = bar_with_button();
  const Clip clip = animate(shot_of(test::held_bar + "  more: {select: {axis: z, above: 1, below: 2}}\n" +
                                    tip + "attach: [{select: {component: 1}, to: {axis: z, below: 1}}]\n"),
                            mesh);
  EXPECT_LT(off(mesh, clip.frames.back(), Eigen::Affine3d::Identity()), 1e-9) << "the bottom is held";
}

TEST(Attach, WhatIsWrongIsSaidWithItsPlace) {
  const auto message = [](const std::string& attach) -> std::string {
    try {
      bind_shot(shot_of(test::held_bar + tip + "attach: " + attach + "\n"), bar_with_button());
    } catch (const TimelineError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(message("[{select: {axis: z, above: 4, below: 5}}]"),
            "shot.yaml:5:10: error: what is attached has to be a part by itself; this shares edges with what "
            "is solved");
  EXPECT_EQ(message("[{select: {axis: z, above: 7}}]"),
            "shot.yaml:5:10: error: vertices of handle 'tip' cannot be attached; they are led");
  EXPECT_EQ(message("{select: {component: 1}}"),
            "shot.yaml:5:9: error: 'attach' is a list of {select: {group: button}, to: {group: coat}}, not a "
            "mapping");
  EXPECT_EQ(message("[{select: {component: 1}, to: {component: 1}}]"),
            "shot.yaml:5:10: error: nothing is solved of what 'attach' names under 'to'");
}

}  // namespace
}  // namespace flexkey
