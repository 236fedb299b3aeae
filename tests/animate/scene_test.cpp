#include "flexkey/animate/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "animate/shots.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

using test::held_bar;
using test::shot_of;
using test::two_bars;
using testing::ElementsAre;
using testing::HasSubstr;

/// What bind_shot refuses, one message a line with its line number.
std::vector<std::string> errors_of(const std::string& text, const Mesh& mesh) {
  std::vector<std::string> lines;
  try {
    bind_shot(shot_of(text), mesh);
  } catch (const TimelineError& error) {
    for (const Diagnostic& diagnostic : error.diagnostics())
      lines.push_back(format_diagnostic(error.file(), diagnostic));
  }
  return lines;
}

TEST(Scene, CountsWhatIsLedAndWhatIsFree) {
  const Mesh bar = meshes::bar(2, 2, 8);
  const Scene scene = bind_shot(shot_of(held_bar + "  tip: {select: {axis: z, above: 100%}}\n"), bar);
  ASSERT_EQ(scene.handles.size(), 2u);
  EXPECT_EQ(scene.handles[0].vertices.size(), 9u);
  EXPECT_EQ(scene.constraints.handles.size(), 18u);
  EXPECT_EQ(scene.region_vertices, bar.vertex_count());
  EXPECT_EQ(scene.free_vertices, bar.vertex_count() - 18);
}

TEST(Scene, ThePivotIsTheCentroidUnlessGiven) {
  const Mesh bar = meshes::bar(2, 2, 8);
  const Bounds bounds = bounds_of(bar.positions);
  const Scene scene =
      bind_shot(shot_of(held_bar + "  tip: {select: {axis: z, above: 100%}, pivot: [1, 2, 3]}\n"), bar);
  EXPECT_NEAR(scene.handles[0].pivot.x(), (bounds.min.x() + bounds.max.x()) / 2, 1e-12);
  EXPECT_EQ(scene.handles[1].pivot, Vec3(1, 2, 3));
}

TEST(Scene, HandlesThatShareVerticesAreNamedWithTheirCount) {
  EXPECT_THAT(errors_of(held_bar + "  low: {select: {axis: z, below: 15%}}\n", meshes::bar(2, 2, 8)),
              ElementsAre("shot.yaml:4:3: error: handles 'base' and 'low' share 9 vertices; "
                          "a vertex follows one handle only"));
}

TEST(Scene, EverySelectionThatFailsIsReported) {
  const std::vector<std::string> errors =
      errors_of(held_bar + "  a: {select: {group: nose}}\n  b: {select: {axis: x, above: 900}}\n",
                meshes::bar(2, 2, 8));
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[0], "shot.yaml:4:23: error: handle 'a': no group 'nose' in bar.obj; it has no groups");
  EXPECT_THAT(errors[1], HasSubstr("handle 'b': the selection takes no vertex; the nearest, vertex"));
}

TEST(Scene, AHandleOutsideTheRegionIsAnError) {
  EXPECT_THAT(errors_of(held_bar + "roi: {axis: z, above: 50%}\n", meshes::bar(2, 2, 8)),
              ElementsAre("shot.yaml:3:3: error: 9 of the 9 vertices of handle 'base' lie outside the roi"));
}

TEST(Scene, WhatLiesOutsideTheRegionHoldsItsComponent) {
  const Scene scene = bind_shot(
      shot_of(
          "mesh: bar.obj\nroi: {axis: z, above: 50%}\nhandles: {tip: {select: {axis: z, above: 100%}}}\n"),
      meshes::bar(2, 2, 8));
  EXPECT_TRUE(scene.riders.empty());
  EXPECT_GT(scene.free_vertices, 0);
  EXPECT_LT(scene.region_vertices, scene.weld.surface.vertex_count());
}

TEST(Scene, ALooseComponentRidesIsHeldOrRefused) {
  const Mesh pair = two_bars();
  const std::string led = "handles: {base: {select: {component: 0}}}\n";
  EXPECT_EQ(bind_shot(shot_of("mesh: pair.obj\n" + led), pair).riders.size(), 1u);
  EXPECT_TRUE(bind_shot(shot_of("mesh: {file: pair.obj, loose: hold}\n" + led), pair).riders.empty());
  const std::vector<std::string> errors = errors_of("mesh: {file: pair.obj, loose: error}\n" + led, pair);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_THAT(errors[0], HasSubstr("component 1 of pair.obj"));
}

}  // namespace
}  // namespace flexkey
