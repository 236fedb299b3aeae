#include <gmock/gmock.h>

#include <limits>

#include "flexkey/mesh/error.h"
#include "preview/pictures.h"

namespace flexkey {
namespace {

using testing::HasSubstr;

/// The message of the error that rendering with these options gives.
std::string refusal(RenderOptions options) {
  const Mesh cube = meshes::cube();
  try {
    Renderer renderer(cube, bounds_of(cube.positions), std::move(options));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

RenderOptions sized(int width, int height) {
  RenderOptions options;
  options.width = width;
  options.height = height;
  return options;
}

TEST(RendererErrors, SizesThatCannotBe) {
  EXPECT_THAT(refusal(sized(0, 540)), HasSubstr("0 x 540 pixels has no pixel"));
  EXPECT_THAT(refusal(sized(960, -1)), HasSubstr("no pixel"));
  EXPECT_THAT(refusal(sized(100000, 100000)),
              HasSubstr("100000 x 100000 pixels is too large: at most 16384 a side"));
  EXPECT_THAT(refusal(sized(16384, 16384)), HasSubstr("too large"));
  EXPECT_EQ(refusal(sized(1, 1)), "accepted");
}

TEST(RendererErrors, SamplesAndLevelsThatCannotBe) {
  RenderOptions options;
  options.samples = 0;
  EXPECT_THAT(refusal(options), HasSubstr("0 samples a pixel are outside 1..4096"));
  options.samples = 8;
  options.subdivide = 7;
  EXPECT_THAT(refusal(options), HasSubstr("subdivision level 7 is outside 0..4"));
}

TEST(RendererErrors, FramesThatDoNotFit) {
  const Sitting cube = sitting(meshes::cube());
  Renderer renderer(cube.mesh, bounds_of(cube.mesh.positions), cube.options);
  const auto message = [&](const FrameState& frame) -> std::string {
    try {
      renderer.render(frame, cube.camera());
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(message({Positions::Zero(7, 3)}), HasSubstr("a frame of 7 vertices does not fit a mesh of 8"));
  Positions broken = cube.mesh.positions;
  broken(5, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(message({broken}), HasSubstr("vertex 5 of the frame"));
  EXPECT_THAT(message({cube.mesh.positions, {}, true, {{8}, {}, {}}}), HasSubstr("no vertex 8"));
}

TEST(RendererErrors, AMeshThatCannotBeSubdividedIsDrawnWithOneWarning) {
  const Sitting fins = sitting(meshes::make_mesh({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
                                                 {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  Renderer renderer(fins.mesh, bounds_of(fins.mesh.positions), fins.options);
  EXPECT_THAT(renderer.warnings(), testing::ElementsAre(HasSubstr("0-1")));
  renderer.render({fins.mesh.positions}, fins.camera());
}

TEST(RendererErrors, FlatAndSinglePointMeshesAreDrawn) {
  sitting(meshes::grid(1, 1)).take();
  const Sitting point = sitting(meshes::make_mesh({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}));
  for (const float value : point.take().rgb) EXPECT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace flexkey
