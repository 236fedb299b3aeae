#pragma once

#include <Eigen/Geometry>
#include <string_view>
#include <vector>

#include "flexkey/mesh/error.h"
#include "flexkey/timeline/motion.h"

namespace flexkey {

/// A motion as a table has it: time in seconds, tx ty tz, and rx ry rz in degrees (about the fixed x first,
/// then y, then z) or a quaternion qx qy qz qw; in this order, or as a first line of these names has them.
/// Relative to the first sample, linear between samples. Throws InputError with the line.
MotionTracks motion_of_table(std::string_view text);

/// A moving frame at one time.
struct MotionSample {
  double time = 0;  // seconds
  Vec3 move{0, 0, 0};
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Vec3 scale{1, 1, 1};
};

/// Samples by increasing time as tracks, relative to the first.
MotionTracks relative_tracks(const std::vector<MotionSample>& samples);

}  // namespace flexkey
