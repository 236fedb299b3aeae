#include "flexkey/animate/animate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "animate/shots.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

using test::held_bar;
using test::shot_of;
using test::two_bars;

const std::string bent = held_bar +
                         "  tip:\n"
                         "    select: {axis: z, above: 100%}\n"
                         "    rotate: {axis: x, keys: {0.25s: 0deg, 1s: 40deg}}\n"
                         "    move: {keys: {0.25s: [0, 0, 0], 1s: [0, 0.3, 0.1]}}\n"
                         "fps: 8\n";

TEST(Animate, MakesAFrameForEachKFromZeroToTheLastKey) {
  const Clip clip = animate(shot_of(bent), meshes::bar(2, 2, 8));
  ASSERT_EQ(clip.frames.size(), 9u);
  EXPECT_EQ(clip.reports.back().frame, 8);
  EXPECT_EQ(clip.fps, 8);
  EXPECT_EQ(clip.name, "shot");
}

TEST(Animate, FramesAtRestAreTheRestMeshBitForBit) {
  const Mesh bar = meshes::bar(2, 2, 8);
  const Clip clip = animate(shot_of(bent), bar);
  EXPECT_EQ(clip.frames[0], bar.positions);
  EXPECT_EQ(clip.frames[2], bar.positions);  // at the first key, 0.25 s
  EXPECT_NE(clip.frames[3], bar.positions);
}

TEST(Animate, HandlesAndAnchorsAreMetToTheLastBit) {
  const Mesh bar = meshes::bar(2, 2, 8);
  const Shot shot = shot_of(bent);
  const Scene scene = bind_shot(shot, bar);
  const Clip clip = animate(shot, bar, scene);
  for (std::size_t k = 0; k < clip.frames.size(); ++k) {
    const Positions targets = sample_targets(scene, static_cast<double>(k) / shot.fps);
    for (std::size_t h = 0; h < scene.constraints.handles.size(); ++h)
      EXPECT_EQ(clip.frames[k].row(scene.constraints.handles[h]), targets.row(static_cast<Eigen::Index>(h)));
  }
}

TEST(Animate, WantedFramesAreThoseOfTheWholeSolve) {
  const Mesh bar = meshes::bar(2, 2, 8);
  const Shot shot = shot_of(bent);
  const Clip whole = animate(shot, bar), part = animate(shot, bar, bind_shot(shot, bar), {4, 7});
  ASSERT_EQ(part.frames.size(), 2u);
  EXPECT_EQ(part.frames[0], whole.frames[4]);
  EXPECT_EQ(part.frames[1], whole.frames[7]);
  EXPECT_EQ(part.reports[1].frame, 7);
}

TEST(Animate, WantedFramesPassByWithTheirHandlesWithoutBeingKept) {
  const Mesh bar = meshes::bar(2, 2, 8);
  const Shot shot = shot_of(bent);
  const Scene scene = bind_shot(shot, bar);
  const Clip kept = animate(shot, bar, scene, {4, 7});
  std::vector<Positions> passed;
  AnimateHooks hooks;
  hooks.keep = Keep::nothing;
  hooks.on_wanted = [&](std::size_t, const SolvedFrame& frame) {
    passed.push_back(frame.positions);
    ASSERT_EQ(frame.handles.size(), scene.handles.size());
    for (std::size_t h = 0; h < frame.handles.size(); ++h)
      for (const int v : scene.handles[h].vertices) {
        const Eigen::Vector4d rest(bar.positions(v, 0), bar.positions(v, 1), bar.positions(v, 2), 1);
        const Eigen::Vector4d moved = frame.handles[h] * rest;
        EXPECT_LT((moved.head<3>().transpose() - frame.positions.row(v)).norm(), 1e-12);
      }
  };
  const Clip clip = animate(shot, bar, scene, {4, 7}, hooks);
  EXPECT_EQ(passed, kept.frames);
  EXPECT_TRUE(clip.frames.empty());
  ASSERT_EQ(clip.reports.size(), 2u);
  EXPECT_EQ(clip.reports[1].frame, 7);
}

TEST(Animate, StopsAfterTheFrameInWhichItIsTold) {
  const Mesh bar = meshes::bar(2, 2, 8);
  const Shot shot = shot_of(bent);
  int heard = 0;
  AnimateHooks hooks;
  hooks.on_frame = [&](std::size_t, const FrameReport&) { ++heard; };
  hooks.stop = [&] { return heard == 3; };
  EXPECT_EQ(animate(shot, bar, bind_shot(shot, bar), {}, hooks).frames.size(), 3u);
}

TEST(Animate, ASweepSolvedTogetherIsItsRunsSolvedAlone) {
  const Mesh bar = meshes::bar(2, 2, 8);
  std::vector<Shot> shots(6, shot_of(bent));  // more than the factor passes over at once
  const double lambdas[] = {0, 0.2, 0.4, 0.6, 0.8, 1};
  for (std::size_t k = 0; k < shots.size(); ++k) shots[k].lambda = {{0, lambdas[k], {}}};
  const Scene scene = bind_shot(shots[0], bar);
  std::vector<Take> takes;
  for (const Shot& shot : shots) takes.push_back({shot, scene});
  const std::vector<Clip> together = animate(takes, bar);
  for (std::size_t k = 0; k < shots.size(); ++k) {
    const Clip alone = animate(shots[k], bar, scene);
    ASSERT_EQ(together[k].frames.size(), alone.frames.size());
    for (std::size_t f = 0; f < alone.frames.size(); ++f) {
      EXPECT_EQ(together[k].frames[f], alone.frames[f]) << "λ " << lambdas[k] << " frame " << f;
      EXPECT_EQ(together[k].reports[f].solves, alone.reports[f].solves);
    }
  }
}

TEST(Animate, ShotsOfOtherConstraintsAreNotSolvedTogether) {
  const Mesh bar = meshes::bar(2, 2, 8);
  const Shot shot = shot_of(bent);
  const Scene scene = bind_shot(shot, bar);
  Scene other = scene;
  other.constraints.handles.pop_back();
  other.constraints.owner.pop_back();
  const Take takes[] = {{shot, scene}, {shot, other}};
  EXPECT_THROW(animate(takes, bar), DeformError);
}

TEST(Animate, ASeamNeverOpens) {
  const Mesh whole = meshes::bar(2, 2, 8);
  Mesh seamed = whole;  // every face gets vertices of its own
  seamed.positions = whole.positions(whole.corners, Eigen::all);
  for (std::size_t k = 0; k < seamed.corners.size(); ++k) seamed.corners[k] = static_cast<int>(k);
  const Clip clip = animate(shot_of(bent), seamed), reference = animate(shot_of(bent), whole);
  for (std::size_t k = 0; k < clip.frames.size(); ++k) {
    const Positions expected = reference.frames[k](whole.corners, Eigen::all);
    EXPECT_LT((clip.frames[k] - expected).cwiseAbs().maxCoeff(), 1e-9) << "frame " << k;
  }
}

TEST(Animate, LambdaFollowsItsKeys) {
  const Clip clip = animate(shot_of(bent + "lambda: {0s: 0, 1s: 1}\n"), meshes::bar(2, 2, 8));
  EXPECT_EQ(clip.reports[0].lambda, 0);
  EXPECT_NEAR(clip.reports[4].lambda, 0.5, 1e-12);
  EXPECT_EQ(clip.reports[8].lambda, 1);
}

TEST(Animate, ALooseComponentRidesRigidlyOnItsCarrier) {
  const Mesh pair = two_bars();
  const Shot shot = shot_of(
      "mesh: pair.obj\nfps: 4\n"
      "handles: {all: {select: {component: 0}, rotate: {axis: y, keys: {0s: 0deg, 1s: 70deg}}, pivot: [1, 2, "
      "3]}}\n");
  const Clip clip = animate(shot, pair);
  EXPECT_EQ(clip.frames[0], pair.positions);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(70 * M_PI / 180, Vec3::UnitY()).toRotationMatrix();
  const Vec3 pivot(1, 2, 3);
  for (int v = 0; v < pair.vertex_count(); ++v) {
    const Vec3 expected = pivot + turn * (pair.positions.row(v).transpose() - pivot);
    EXPECT_LT((clip.frames[4].row(v).transpose() - expected).norm(), 1e-9) << "vertex " << v;
  }
}

}  // namespace
}  // namespace flexkey
