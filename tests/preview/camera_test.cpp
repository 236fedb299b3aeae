#include "flexkey/preview/camera.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "flexkey/mesh/error.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

constexpr int kHeight = 540;
constexpr double kAspect = 16.0 / 9;
constexpr double kDegree = std::numbers::pi / 180;

/// A bar that wanders off over three frames.
std::array<Positions, 3> wander() {
  const Mesh bar = meshes::bar(1, 2, 5);
  return {bar.positions, meshes::moved(bar.positions, meshes::turn(50, {0, 1, 0}), {4, 0, 0}),
          meshes::moved(bar.positions, meshes::turn(120, {1, 1, 0}), {3, -2, 6})};
}

/// Pixels between the points and the picture's nearest side; negative: outside.
double room(const Camera& camera, std::span<const Positions> frames) {
  double least = std::numeric_limits<double>::infinity();
  for (const Positions& frame : frames) {
    for (Eigen::Index v = 0; v < frame.rows(); ++v) {
      const Vec3 seen = project(camera, frame.row(v), kHeight);
      if (seen.z() <= 0) return -1;
      least = std::min({least, seen.x(), seen.y(), kHeight * kAspect - seen.x(), kHeight - seen.y()});
    }
  }
  return least;
}

TEST(Camera, HoldsAllFramesFromAnySide) {
  const auto frames = wander();
  for (const Up up : {Up::y, Up::z}) {
    for (const double elevation : {-90.0, -20.0, 0.0, 35.0, 90.0}) {
      for (const double azimuth : {0.0, 45.0, 200.0}) {
        CameraSettings settings;
        settings.up = up;
        settings.azimuth = azimuth * kDegree;
        settings.elevation = elevation * kDegree;
        const double left = room(fit_camera(settings, frames, kAspect), frames);
        EXPECT_GE(left, settings.margin * kHeight - 1) << azimuth << " " << elevation;
        EXPECT_LE(left, settings.margin * kHeight * 2) << "not farther off than need be";
      }
    }
  }
}

TEST(Camera, LeavesTheFooterFree) {
  const auto frames = wander();
  CameraSettings settings;
  settings.footer = 0.2;
  for (const std::optional<Vec3>& look_at : {std::optional<Vec3>(), std::optional<Vec3>({1, 2, 5})}) {
    settings.look_at = look_at;
    const Camera camera = fit_camera(settings, frames, kAspect);
    double lowest = 0, highest = kHeight;
    for (const Positions& frame : frames)
      for (const auto& p : frame.rowwise()) {
        lowest = std::max(lowest, project(camera, p.transpose(), kHeight).y());
        highest = std::min(highest, project(camera, p.transpose(), kHeight).y());
      }
    EXPECT_LE(lowest, kHeight * (1 - settings.footer - settings.margin) + 1);
    EXPECT_GE(highest, kHeight * settings.margin - 1);
    if (!look_at) {
      EXPECT_NEAR(highest + kHeight * settings.footer, kHeight - lowest, 2) << "as much room above as below";
    }
  }
}

TEST(Camera, LooksAtTheChosenPointAndHoldsAll) {
  const auto frames = wander();
  CameraSettings settings;
  settings.look_at = Vec3(1, 2, 5);
  const Camera camera = fit_camera(settings, frames, kAspect);
  const Vec3 seen = project(camera, *settings.look_at, kHeight);
  EXPECT_NEAR(seen.x(), kHeight * kAspect / 2, 1e-6);
  EXPECT_NEAR(seen.y(), kHeight / 2.0, 1e-6);
  EXPECT_GE(room(camera, frames), settings.margin * kHeight - 1);
}

TEST(Camera, NeverRolls) {
  CameraSettings settings;
  for (const Up up : {Up::y, Up::z}) {
    settings.up = up;
    for (const double elevation : {-80.0, 10.0, 90.0}) {
      settings.elevation = elevation * kDegree;
      const Camera camera = fit_camera(settings, wander(), kAspect);
      EXPECT_NEAR(camera.right.dot(up_vector(up)), 0, 1e-12);
      EXPECT_NEAR(camera.right.cross(camera.up).dot(camera.forward), -1, 1e-12);
    }
  }
}

TEST(Camera, AzimuthStartsAtTheFrontAndGrowsTowardsX) {
  CameraSettings settings;
  settings.elevation = 0;
  settings.azimuth = 0;
  EXPECT_LT((fit_camera(settings, wander(), kAspect).forward - Vec3(0, 0, -1)).norm(), 1e-12);
  settings.azimuth = 90 * kDegree;
  EXPECT_LT((fit_camera(settings, wander(), kAspect).forward - Vec3(-1, 0, 0)).norm(), 1e-12);
  settings.up = Up::z;
  settings.azimuth = 0;
  EXPECT_LT((fit_camera(settings, wander(), kAspect).forward - Vec3(0, 1, 0)).norm(), 1e-12);
}

TEST(Camera, ATurntableHoldsAllAtEveryTurn) {
  const auto frames = wander();
  const CameraSettings settings;
  const Camera camera = fit_camera(settings, frames, kAspect, Turning::yes);
  for (int turn = 0; turn < 12; ++turn)
    EXPECT_GE(room(turned(camera, turn * 30 * kDegree, settings.up), frames), 0) << turn;
}

TEST(Camera, TurningIsTheSameAsAnotherAzimuth) {
  CameraSettings settings;
  settings.look_at = Vec3(1, 1, 1);
  const Camera turned_camera =
      turned(fit_camera(settings, wander(), kAspect, Turning::yes), 40 * kDegree, Up::y);
  settings.azimuth += 40 * kDegree;
  const Camera aimed = fit_camera(settings, wander(), kAspect, Turning::yes);
  EXPECT_LT((turned_camera.forward - aimed.forward).norm(), 1e-12);
  EXPECT_LT((turned_camera.right - aimed.right).norm(), 1e-12);
}

TEST(Camera, ZoomEnlarges) {
  CameraSettings settings;
  const Camera plain = fit_camera(settings, wander(), kAspect);
  settings.zoom = 2;
  const Camera near = fit_camera(settings, wander(), kAspect);
  const Vec3 corner(4, 1, 1);
  const double half = kHeight / 2.0;
  EXPECT_NEAR(project(near, corner, kHeight).y() - half, 2 * (project(plain, corner, kHeight).y() - half),
              1e-6);
}

TEST(Camera, StandsOffAPointAndNothing) {
  const Positions point = Positions::Constant(1, 3, 7.0);
  const Camera camera = fit_camera({}, std::span(&point, 1), kAspect);
  EXPECT_GT(project(camera, Vec3(7, 7, 7), kHeight).z(), 0);
  EXPECT_TRUE(fit_camera({}, {}, kAspect).position.allFinite());
}

TEST(Camera, RefusesWhatIsNoCamera) {
  const auto with = [](auto change) {
    CameraSettings settings;
    change(settings);
    return fit_camera(settings, wander(), kAspect);
  };
  EXPECT_THROW(with([](CameraSettings& s) { s.fov = 0; }), InputError);
  EXPECT_THROW(with([](CameraSettings& s) { s.fov = 4; }), InputError);
  EXPECT_THROW(with([](CameraSettings& s) { s.elevation = 2; }), InputError);
  EXPECT_THROW(with([](CameraSettings& s) { s.zoom = 0; }), InputError);
  EXPECT_THROW(with([](CameraSettings& s) { s.footer = 0.9; }), InputError);
  EXPECT_THROW(with([](CameraSettings& s) { s.look_at = Vec3::Constant(std::nan("")); }), InputError);
}

}  // namespace
}  // namespace flexkey
