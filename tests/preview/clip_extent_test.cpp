#include "flexkey/preview/clip_extent.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flexkey/mesh/error.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

constexpr double kAspect = 16.0 / 9;

/// A sphere that flies about and grows.
std::vector<Positions> flight() {
  const Positions sphere = meshes::sphere(2).positions;
  std::vector<Positions> frames;
  for (int k = 0; k < 12; ++k)
    frames.push_back(((1 + 0.1 * k) * sphere).rowwise() +
                     Eigen::RowVector3d(std::cos(k), 0.3 * k, 2 * std::sin(0.7 * k)));
  return frames;
}

CameraSettings looking(double azimuth, double elevation, Up up) {
  CameraSettings settings;
  settings.azimuth = azimuth;
  settings.elevation = elevation;
  settings.up = up;
  settings.footer = 0.07;
  return settings;
}

TEST(ClipExtent, FramesLikeAllFrames) {
  const std::vector<Positions> frames = flight();
  for (const Up up : {Up::y, Up::z})
    for (const double elevation : {-1.2, 0.0, 0.4})
      for (const Turning turning : {Turning::no, Turning::yes}) {
        const CameraSettings settings = looking(0.6, elevation, up);
        ClipExtent extent(settings, frames.front());
        for (const Positions& frame : frames) extent.add(frame);
        const Camera whole = fit_camera(settings, frames, kAspect, turning);
        const Camera outline = fit_camera(settings, std::span(&extent.outline(), 1), kAspect, turning);
        EXPECT_LT((whole.position - outline.position).norm(), 1e-12) << elevation;
        EXPECT_LT((whole.centre - outline.centre).norm(), 1e-12);
      }
}

TEST(ClipExtent, HasTheBoundsAndTheLargestOffset) {
  const std::vector<Positions> frames = flight();
  ClipExtent extent(looking(0.6, 0.2, Up::y), frames.front());
  double largest = 0;
  for (const Positions& frame : frames) {
    extent.add(frame);
    largest = std::max(largest, (frame - frames.front()).rowwise().norm().maxCoeff());
  }
  EXPECT_EQ(bounds_of(extent.outline()).min, bounds_of(frames).min);
  EXPECT_EQ(bounds_of(extent.outline()).max, bounds_of(frames).max);
  EXPECT_DOUBLE_EQ(extent.largest_offset(), largest);
}

TEST(ClipExtent, JoinsClipsAndForgetsTheirOrder) {
  const std::vector<Positions> frames = flight();
  const CameraSettings settings = looking(0.6, 0.2, Up::y);
  ClipExtent all(settings, frames[0]), even(settings, frames[0]), odd(settings, frames[0]);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    all.add(frames[k]);
    (k % 2 == 0 ? even : odd).add(frames[k]);
  }
  odd.join(even);
  const auto place = [&](const ClipExtent& extent) {
    return fit_camera(settings, std::span(&extent.outline(), 1), kAspect).position;
  };
  EXPECT_LT((place(odd) - place(all)).norm(), 1e-12);
  EXPECT_DOUBLE_EQ(odd.largest_offset(), all.largest_offset());
}

TEST(ClipExtent, StaysSmall) {
  const std::vector<Positions> frames = flight();
  ClipExtent extent(looking(0.6, 0.2, Up::y), frames.front());
  for (int lap = 0; lap < 20; ++lap)
    for (const Positions& frame : frames) extent.add(frame);
  EXPECT_LT(extent.outline().rows(), 2 * frames.front().rows());
}

TEST(ClipExtent, RefusesWhatIsNowhere) {
  Positions frame = meshes::cube().positions;
  ClipExtent extent({}, frame);
  frame(3, 1) = std::nan("");
  EXPECT_THROW(extent.add(frame), InputError);
}

}  // namespace
}  // namespace flexkey
