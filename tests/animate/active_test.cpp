// Handles that take hold and let go.
#include <gtest/gtest.h>

#include "animate/shots.h"
#include "flexkey/animate/animate.h"
#include "flexkey/animate/deformer_cache.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

using test::held_bar;
using test::shot_of;

const Mesh bar = meshes::bar(2, 2, 8);

/// The tip goes sideways by 2 in the first second and stays; `more` says when it holds. Two seconds, 8 fps.
std::string shot_text(const std::string& more) {
  return held_bar + "  tip:\n    select: {axis: z, above: 100%}\n" +
         "    move: {keys: {0s: [0, 0, 0], 1s: [0, 2, 0]}}\n" + more + "fps: 8\nduration: 2s\n";
}

std::string refusal(const std::string& text) {
  try {
    bind_shot(shot_of(text), bar);
  } catch (const TimelineError& error) {
    return error.what();
  }
  return "nothing";
}

double largest(const Positions& difference) {
  return difference.rowwise().norm().maxCoeff();
}

Positions tip_of(const Positions& frame) {
  return frame(meshes::between(bar, 2, 8, 8), Eigen::all);
}

TEST(Active, AHandleThatIsAlwaysActiveIsAsOneWithoutTheKey) {
  const Clip plain = animate(shot_of(shot_text("")), bar);
  const Clip active = animate(shot_of(shot_text("    active: [0s, 9s]\n")), bar);
  for (std::size_t k = 0; k < plain.frames.size(); ++k)
    EXPECT_LT(largest(plain.frames[k] - active.frames[k]), 1e-9) << "frame " << k;
}

TEST(Active, ItsVerticesAreMetWhileItHoldsAndGoBackToRestWhenItLetsGo) {
  const Shot shot =
      shot_of(shot_text("    active: [0.5s, 1.5s]\nsolver: {tolerance: 1e-6, iterations: 500}\n"));
  const Clip clip = animate(shot, bar);
  for (int k = 0; k < 17; ++k) {
    const Positions moved = tip_of(bar.positions).rowwise() + Eigen::RowVector3d(0, std::min(k, 8) / 4.0, 0);
    const Positions found = tip_of(clip.frames[static_cast<std::size_t>(k)]);
    if (k >= 4 && k < 12) {
      EXPECT_EQ(found, moved) << "frame " << k;
    } else {
      EXPECT_LT(largest(found - tip_of(bar.positions)), 1e-3) << "frame " << k;
    }
  }
  EXPECT_EQ(clip.frames[3], bar.positions);
}

TEST(Active, AHandleMayHandOverItsVertices) {
  const std::string text =
      held_bar +
      "  first: {select: {axis: z, above: 100%}, active: [0s, 1s]}\n"
      "  second: {select: {axis: z, above: 7}, active: [1s, 3s], rotate: {axis: z, keys: {1s: "
      "0deg, 2s: 90deg}}}\nfps: 4\n";
  const Clip clip = animate(shot_of(text), bar);
  EXPECT_EQ(tip_of(clip.frames[3]), tip_of(bar.positions));
  const Positions turned = meshes::moved(tip_of(bar.positions), meshes::turn(90, Vec3::UnitZ()), {2, 0, 0});
  EXPECT_LT(largest(tip_of(clip.frames[8]) - turned), 1e-12);
  EXPECT_EQ(
      refusal(held_bar + "  a: {select: {axis: z, above: 7}, active: [0s, 1s]}\n  b: {select: {axis: z, "
                         "above: 7}, active: [0.9s, 2s]}\n"),
      "shot.yaml:5:3: error: handles 'a' and 'b' share 17 vertices; a vertex follows one handle only");
}

TEST(Active, WhatWasTurnedInsideAHandleStaysTurnedWhenItLetsGo) {
  const std::string text =
      held_bar +
      "  tip: {select: {axis: z, above: 4}, active: [0s, 1s], rotate: {axis: z, keys: {0s: "
      "0deg, 1s: 120deg}}}\n  top: {select: {axis: z, above: 100%}, active: [1s, 2s], rotate: "
      "{axis: z, keys: {0s: 0deg, 1s: 120deg}}}\n"
      "fps: 8\nduration: 1.5s\nsolver: {iterations: 200}\n";
  const Clip clip = animate(shot_of(text), bar);
  // The lower half takes up its share of the turn, while nothing folds: every edge keeps about its length.
  for (int f = 0; f < bar.face_count(); ++f) {
    const auto face = bar.face(f);
    for (std::size_t k = 0; k < 4; ++k) {
      const double length =
          (clip.frames.back().row(face[k]) - clip.frames.back().row(face[(k + 1) % 4])).norm();
      EXPECT_GT(length, 0.5);
      EXPECT_LT(length, 1.6);
    }
  }
}

TEST(Fade, StartsAndEndsAtTheFreeSolution) {
  const std::string solver = "solver: {tolerance: 1e-7, iterations: 1000}\n";
  const Clip clip =
      animate(shot_of(shot_text("    active: [0.5s, 2s]\n    fade: 0.5s\n") + "lambda: 0.3\n" + solver), bar);
  const Positions rest = tip_of(bar.positions);
  const auto way = [&](int k) {
    return (tip_of(clip.frames[static_cast<std::size_t>(k)]) - rest).col(1).mean();
  };
  EXPECT_NEAR(way(4), 0, 1e-4);        // a = 0
  EXPECT_NEAR(way(6), 1.5 / 2, 1e-4);  // a = 1/2 between rest, where the free bar is, and the target
  EXPECT_EQ(way(8), 2);
  EXPECT_EQ(way(12), 2);
  EXPECT_NEAR(way(14), 1, 1e-4);
  EXPECT_NEAR(way(16), 0, 1e-4);
  for (int k = 1; k < 17; ++k) EXPECT_LT(std::abs(way(k) - way(k - 1)), 0.8) << "frame " << k;
}

TEST(Fade, TakesThatAreSolvedTogetherAreAsSingleOnes) {
  const std::string text = shot_text("    active: [0.25s, 1.5s]\n    fade: 0.25s\n");
  const Shot soft = shot_of(text + "lambda: 0.2\n"), stiff = shot_of(text + "lambda: 0.8\n");
  const Scene scene = bind_shot(soft, bar);
  const std::vector<Take> takes = {{soft, scene}, {stiff, scene}};
  const std::vector<Clip> together = animate(takes, bar);
  const Clip first = animate(soft, bar, scene), second = animate(stiff, bar, scene);
  for (std::size_t k = 0; k < first.frames.size(); ++k) {
    EXPECT_EQ(together[0].frames[k], first.frames[k]) << "frame " << k;
    EXPECT_EQ(together[1].frames[k], second.frames[k]) << "frame " << k;
  }
}

TEST(Active, ATimeAtWhichNothingHoldsTheSurfaceIsNamed) {
  const std::string text = "mesh: bar.obj\nfps: 8\nduration: 2s\nhandles:\n";
  EXPECT_EQ(
      refusal(text + "  a: {select: {axis: z, below: 0}, active: [0s, 1s]}\n"
                     "  b: {select: {axis: z, above: 8}, active: [1.25s, 9s]}\n"),
      "shot.yaml:5:3: error: nothing holds the surface of 'a' at 1s: no handle on it is active; hold it "
      "somewhere at every time");
  EXPECT_EQ(refusal(text + "  a: {select: {axis: z, below: 0}, active: [0s, 1s]}\n"
                           "  b: {select: {axis: z, above: 8}, active: [1s, 9s]}\n"),
            "nothing");
  EXPECT_EQ(
      refusal(text + "  a: {select: {axis: z, below: 0}, active: [0s, 1s]}\n"
                     "  b: {select: {axis: z, above: 8}, active: [1s, 9s], fade: 0.5s}\n"),
      "shot.yaml:6:3: error: nothing holds the surface of 'b' at 1s: all that is active on it fades; hold "
      "it somewhere at every time");
  EXPECT_EQ(
      refusal("roi: {axis: z, above: 2}\n" + text + "  a: {select: {axis: z, above: 8}, active: [0s, 1s]}\n"),
      "nothing");
}

TEST(DeformerCache, KeepsWhatWasLastAskedForWithinItsBound) {
  const Scene scene = bind_shot(shot_of(shot_text("    active: [0s, 1s]\n")), bar);
  DeformerCache roomy(scene, {});
  const auto both = roomy.of({0, 1}), base = roomy.of({0});
  EXPECT_EQ(roomy.size(), 2u);
  EXPECT_EQ(roomy.of({0, 1}), both);
  EXPECT_EQ(roomy.of({0}), base);
  DeformerCache narrow(scene, {}, both->bytes() + base->bytes() / 2);
  const auto first = narrow.of({0, 1});
  narrow.of({0});
  EXPECT_EQ(narrow.size(), 1u);
  EXPECT_NE(narrow.of({0, 1}), first);
}

}  // namespace
}  // namespace flexkey
