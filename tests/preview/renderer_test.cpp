#include "flexkey/preview/renderer.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "flexkey/preview/light.h"
#include "preview/pictures.h"

namespace flexkey {
namespace {

std::vector<Quality> both() {
  return {Quality::final, Quality::draft};
}

/// The pixel at which the camera sees a point.
Rgb at(const Picture& picture, const Sitting& sitting, const Vec3& point) {
  const Vec3 seen = project(sitting.camera(), point, picture.height);
  return pixel(picture, static_cast<int>(seen.x()), static_cast<int>(seen.y()));
}

TEST(Renderer, NothingIsTheBackdrop) {
  Sitting empty = sitting(Mesh{});
  empty.mesh.positions.resize(0, 3);
  const View view(empty.camera(), UnitSpace({}), empty.options.width, empty.options.height);
  for (const Quality quality : both()) {
    empty.options.quality = quality;
    const Picture picture = empty.take();
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        EXPECT_LT((pixel(picture, x, y) - backdrop(view, x, y)).norm(), 1e-5f) << x << " " << y;
      }
    }
  }
}

TEST(Renderer, ASphereIsLitFromTheKeyLightsSide) {
  Sitting sphere = sitting(meshes::sphere(2));
  sphere.settings.elevation = 0;
  const Camera camera = sphere.camera();
  for (const Quality quality : both()) {
    sphere.options.quality = quality;
    const Picture picture = sphere.take();
    const Vec3 aside = 0.6 * camera.right, above = 0.6 * camera.up;
    const float lit = brightness(at(picture, sphere, above - aside));
    EXPECT_GT(lit, 1.5f * brightness(at(picture, sphere, aside - above)));
    EXPECT_GT(lit, 1.1f * brightness(at(picture, sphere, above + aside)));
  }
}

TEST(Renderer, TheShadowIsDarkerThanTheGround) {
  Sitting sphere = sitting(meshes::sphere(2));
  sphere.settings.elevation = 0.5;
  sphere.settings.zoom = 0.5;
  const Camera camera = sphere.camera();
  const Vec3 ground(0, -1, 0);
  const Vec3 aside = 1.25 * camera.right;  // the key light is at the left
  for (const Quality quality : both()) {
    sphere.options.quality = quality;
    const Picture picture = sphere.take();
    EXPECT_LT(brightness(at(picture, sphere, ground + aside)),
              0.9f * brightness(at(picture, sphere, ground - 1.6 * aside)));
  }
}

TEST(Renderer, NothingIsBlownOut) {
  for (const Style style :
       {Style::clay, Style::normals, Style::lambda, Style::error, Style::wire, Style::displacement}) {
    Sitting sphere = sitting(meshes::sphere(2));
    sphere.options.style = style;
    const Picture picture = sphere.take();
    for (const float value : picture.rgb) {
      EXPECT_GE(value, 0);
      EXPECT_LT(value, 1);
    }
  }
}

TEST(Renderer, TheGroundLiesWhereItIsAskedTo) {
  Sitting sphere = sitting(meshes::sphere(2));
  sphere.settings.elevation = 0.5;
  sphere.settings.zoom = 0.5;
  const Vec3 beside = Vec3(0, -1, 0) + 0.8 * sphere.camera().right;  // in the shadow of a sphere that stands
  for (const Quality quality : both()) {
    sphere.options.quality = quality;
    sphere.options.floor.reset();
    const float standing = brightness(at(sphere.take(), sphere, beside));
    sphere.options.floor = -1;
    EXPECT_EQ(brightness(at(sphere.take(), sphere, beside)), standing);
    sphere.options.floor = -3;
    EXPECT_GT(brightness(at(sphere.take(), sphere, beside)), 1.1f * standing) << "its shadow is elsewhere";
  }
}

TEST(Renderer, LambdaIsPaintedOverTheSurface) {
  Sitting sphere = sitting(meshes::sphere(2));
  sphere.options.style = Style::lambda;
  sphere.settings.elevation = 0;
  const Camera camera = sphere.camera();
  const Eigen::VectorXd across = sphere.mesh.positions * camera.right;
  Renderer renderer(sphere.mesh, bounds_of(sphere.mesh.positions), sphere.options);
  const Eigen::VectorXf lambda = (across.array() > 0).cast<float>();  // rigid on the right
  const Picture picture = renderer.render({sphere.mesh.positions, lambda}, camera);
  const Rgb left = at(picture, sphere, -0.6 * camera.right), right = at(picture, sphere, 0.6 * camera.right);
  EXPECT_GT(left.z(), left.x()) << "blue";
  EXPECT_GT(right.x(), right.z()) << "red";
}

TEST(Renderer, ThreadsDoNotChangeAPixel) {
  Sitting bar = sitting(meshes::bumpy(meshes::bar(8, 9, 40), 0.3));
  for (const Quality quality : both()) {
    bar.options.quality = quality;
    const auto with = [&](std::size_t threads) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      return bar.take().rgb;
    };
    EXPECT_EQ(with(1), with(2));
  }
}

TEST(Renderer, AFrameAloneIsTheFrameInItsClip) {
  Sitting bar = sitting(meshes::bumpy(meshes::bar(3, 4, 12), 0.3));
  const Positions bent = meshes::moved(bar.mesh.positions, meshes::turn(30, {1, 2, 0}), {1, 0, 0});
  Bounds bounds = bounds_of(std::vector<Positions>{bar.mesh.positions, bent});
  for (const Quality quality : both()) {
    bar.options.quality = quality;
    Renderer all(bar.mesh, bounds, bar.options), alone(bar.mesh, bounds, bar.options);
    all.render({bar.mesh.positions, {}, true, {{0, 1, 2}, {3}, bent.topRows(2)}}, bar.camera());
    EXPECT_EQ(all.render({bent}, bar.camera()).rgb, alone.render({bent}, bar.camera()).rgb);
  }
}

TEST(Renderer, DraftAndFinalAgreeInOutline) {
  Sitting bar = sitting(meshes::bumpy(meshes::bar(3, 4, 6), 0.3));
  bar.options.width = 192;
  bar.options.height = 128;
  const Picture traced = bar.take();
  bar.options.quality = Quality::draft;
  const Picture draft = bar.take();
  int covered = 0, apart = 0;
  for (int y = 0; y < traced.height; ++y) {
    for (int x = 0; x < traced.width; ++x) {
      const bool is_traced = is_clay(pixel(traced, x, y));
      covered += is_traced ? 1 : 0;
      apart += is_traced != is_clay(pixel(draft, x, y)) ? 1 : 0;
    }
  }
  EXPECT_GT(covered, 3000);
  EXPECT_LT(apart, covered / 25);
}

TEST(Renderer, PlaceAndScaleDoNotMatter) {
  Sitting bar = sitting(meshes::bumpy(meshes::bar(2, 3, 4), 0.2));
  Sitting far = bar;
  far.mesh.positions = (bar.mesh.positions * 1024).rowwise() + Eigen::RowVector3d(1e6, -2e6, 5e5);
  // The light runs in single precision, so rays along edges may fall to either side.
  EXPECT_LT(differing(bar.take(), far.take(), 0.02f), 96 * 64 / 50);
}

TEST(Renderer, ErrorTintsFramesThatHaveNotConverged) {
  Sitting cube = sitting(meshes::cube());
  cube.options.style = Style::error;
  Renderer renderer(cube.mesh, bounds_of(cube.mesh.positions), cube.options);
  const Rgb calm = at(renderer.render({cube.mesh.positions, {}, true}, cube.camera()), cube, {0.5, 0.5, 0.5});
  const Rgb red = at(renderer.render({cube.mesh.positions, {}, false}, cube.camera()), cube, {0.5, 0.5, 0.5});
  EXPECT_GT(red.x() / red.z(), 2 * calm.x() / calm.z());
}

TEST(Renderer, DisplacementRunsThroughTheMap) {
  Sitting cube = sitting(meshes::cube());
  cube.options.style = Style::displacement;
  cube.options.displacement_top = 0.5;
  const Positions moved = cube.mesh.positions.array() + 0.5;  // half the diagonal
  Renderer renderer(cube.mesh, bounds_of(std::vector<Positions>{cube.mesh.positions, moved}), cube.options);
  const Rgb still = at(renderer.render({cube.mesh.positions}, cube.camera()), cube, {0.5, 0.5, 0.5});
  const Rgb far = at(renderer.render({moved}, cube.camera()), cube, {1.0, 1.0, 1.0});
  EXPECT_GT(still.z(), still.y()) << "violet";
  EXPECT_GT(far.y(), 4 * far.z()) << "yellow";
}

TEST(Renderer, MarksHaveThePapersColours) {
  Sitting cube = sitting(meshes::cube());
  cube.options.subdivide = 0;
  cube.settings.zoom = 0.6;  // the target lies outside the cube
  for (const Quality quality : both()) {
    cube.options.quality = quality;
    cube.options.width = 600;
    cube.options.height = 400;
    Renderer renderer(cube.mesh, bounds_of(cube.mesh.positions), cube.options);
    const auto vertex = [&](const Vec3& place) {
      Eigen::Index found = 0;
      (cube.mesh.positions.rowwise() - place.transpose()).rowwise().norm().minCoeff(&found);
      return static_cast<int>(found);
    };
    FrameState state{cube.mesh.positions};
    state.marks.handles = {vertex({0, 1, 1})};
    state.marks.anchors = {vertex({1, 1, 1})};
    state.marks.targets = Positions::Constant(1, 3, 1.2);
    const Picture picture = renderer.render(state, cube.camera());
    const Rgb handle = at(picture, cube, {0, 1, 1}), anchor = at(picture, cube, {1, 1, 1}),
              target = at(picture, cube, {1.2, 1.2, 1.2});
    EXPECT_GT(handle.z(), 2 * handle.x());
    EXPECT_GT(anchor.x(), 2 * anchor.z());
    EXPECT_GT(target.y(), 2 * target.x());
  }
}

TEST(Renderer, TexturedShowsBaseColoursAndAsksForImages) {
  Sitting sheet = sitting(meshes::grid(2, 1));
  sheet.settings = {{}, 0, 0};
  sheet.mesh.materials = {{"red", {1, 0, 0}, 1, ""}, {"image", {1, 1, 1}, 1, "a.png"}};
  sheet.mesh.face_material = {0, 1};
  sheet.mesh.texcoords = sheet.mesh.positions.leftCols<2>();
  sheet.mesh.corner_texcoord = sheet.mesh.corners;
  sheet.options.style = Style::textured;
  sheet.options.texture = [](int material, const Eigen::Vector2f& uv) -> Rgb {
    return material == 1 && uv.x() >= 1 ? Rgb(0, uv.y(), 0) : Rgb(0, 0, 1);
  };
  const Picture picture = sheet.take();
  const Rgb red = at(picture, sheet, {0.5, 0.5, 0}), green = at(picture, sheet, {1.5, 0.9, 0});
  EXPECT_GT(red.x(), 4 * red.y());
  EXPECT_GT(green.y(), 4 * green.z());
  EXPECT_GT(green.y(), 1.5f * at(picture, sheet, {1.5, 0.3, 0}).y());
}

TEST(Renderer, WiresAreDark) {
  Sitting sheet = sitting(meshes::grid(2, 2));
  sheet.settings = {{}, 0, 0};
  sheet.options.width = sheet.options.height = 256;
  for (const Quality quality : both()) {
    sheet.options.quality = quality;
    sheet.options.style = Style::wire;
    const Picture picture = sheet.take();
    EXPECT_LT(brightness(at(picture, sheet, {1, 0.5, 0})),
              0.6f * brightness(at(picture, sheet, {0.5, 0.5, 0})));
  }
}

}  // namespace
}  // namespace flexkey
