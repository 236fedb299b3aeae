// How handles hold, and what moves as one body.
#include <gtest/gtest.h>

#include "animate/shots.h"
#include "flexkey/animate/animate.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

using test::held_bar;
using test::shot_of;

std::string moved_tip(const std::string& more) {
  return held_bar + "  tip:\n    select: {axis: z, above: 100%}\n" +
         "    move: {keys: {0s: [0, 0, 0], 1s: [0, 1, 0]}}\n" + more + "fps: 4\n";
}

TEST(SoftHandles, GoPartOfTheWayAndStartAtRest) {
  const Mesh bar = meshes::bar(2, 2, 8);
  const Scene scene = bind_shot(shot_of(moved_tip("    weight: 0.5\n")), bar);
  EXPECT_EQ(scene.free_vertices, bar.vertex_count() - 9);
  const std::vector<int>& tip = scene.handles[1].vertices;
  const auto way = [&](const Clip& clip) {
    return (clip.frames.back()(tip, Eigen::all) - bar.positions(tip, Eigen::all)).col(1).mean();
  };
  const Clip half = animate(shot_of(moved_tip("    weight: 0.5\n")), bar);
  const Clip most = animate(shot_of(moved_tip("    weight: 0.9\n")), bar);
  const Clip whole = animate(shot_of(moved_tip("    weight: 1\n")), bar);
  EXPECT_EQ(half.frames[0], bar.positions);
  EXPECT_GT(way(half), 0.5);
  EXPECT_LT(way(half), way(most));
  EXPECT_LT(way(most), 0.999);
  EXPECT_NEAR(way(whole), 1, 1e-12);
}

/// What bind_shot refuses.
std::string refusal(const std::string& text, const Mesh& mesh) {
  try {
    bind_shot(shot_of(text), mesh);
  } catch (const TimelineError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(RigidRegions, MoveAsOneBody) {
  const Mesh bar = meshes::bar(2, 2, 8);
  const Shot shot = shot_of(moved_tip("rigid: {middle: {axis: z, above: 3, below: 5}}\n"));
  const Scene scene = bind_shot(shot, bar);
  ASSERT_EQ(scene.constraints.rigid.size(), 1u);
  const std::vector<int>& middle = scene.constraints.rigid[0];
  EXPECT_EQ(middle, meshes::between(bar, 2, 3, 5));
  const Clip clip = animate(shot, bar, scene);
  const Positions rest = bar.positions(middle, Eigen::all), posed = clip.frames.back()(middle, Eigen::all);
  for (Eigen::Index a = 0; a < rest.rows(); ++a)
    for (Eigen::Index b = 0; b < a; ++b)
      EXPECT_NEAR((posed.row(a) - posed.row(b)).norm(), (rest.row(a) - rest.row(b)).norm(), 1e-12);
  EXPECT_GT((posed - rest).norm(), 0.5);
}

TEST(RigidRegions, ThatTouchAHandleAnotherRegionOrTheOutsideAreRefused) {
  const Mesh bar = meshes::bar(2, 2, 8);
  EXPECT_EQ(refusal(held_bar + "rigid: {foot: {axis: z, below: 1}}\n", bar),
            "shot.yaml:4:9: error: rigid region 'foot' and handle 'base' share 9 vertices; a region moves by "
            "itself, so leave the handle's vertices out of it");
  EXPECT_EQ(refusal(held_bar + "rigid: {a: {axis: z, above: 4}, b: {axis: z, above: 3, below: 4}}\n", bar),
            "shot.yaml:4:33: error: rigid regions 'a' and 'b' share 8 vertices; one region that holds both "
            "moves as one body");
  EXPECT_EQ(refusal(held_bar + "roi: {axis: z, below: 4}\nrigid: {a: {axis: z, above: 4, below: 5}}\n", bar),
            "shot.yaml:5:9: error: 8 of the 16 vertices of rigid region 'a' lie outside the roi");
  EXPECT_EQ(refusal(held_bar + "rigid: {a: {group: tooth}}\n", bar),
            "shot.yaml:4:20: error: rigid region 'a': no group 'tooth' in bar.obj; it has no groups");
}

TEST(RigidRegions, CarryWhatNoHandleTouches) {
  const Mesh pair = test::two_bars();
  const std::string text =
      "mesh: pair.obj\nfps: 4\nrigid: {r: {axis: z, above: 2, below: 5}}\nhandles:\n"
      "  base: {select: {axis: z, below: 0}, rotate: {axis: x, keys: {0s: 0deg, 1s: 50deg}}}\n";
  const Scene scene = bind_shot(shot_of(text), pair);
  EXPECT_TRUE(scene.riders.empty());
  const Clip clip = animate(shot_of(text), pair, scene);
  const Eigen::Matrix3d turn = meshes::turn(50, Vec3::UnitX());
  const Vec3 pivot = scene.handles[0].pivot;
  const Positions expected = meshes::moved(pair.positions, turn, pivot - turn * pivot);
  EXPECT_LT((clip.frames.back() - expected).rowwise().norm().maxCoeff(), 1e-6);
}

}  // namespace
}  // namespace flexkey
