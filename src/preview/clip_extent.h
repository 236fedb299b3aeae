#pragma once

#include <span>
#include <vector>

#include "flexkey/preview/camera.h"

namespace flexkey {

/// What a camera and a scale that serve a whole clip must know of it, gathered a frame at a time: memory does
/// not grow with the frames.
class ClipExtent {
 public:
  /// The camera will look from the azimuth and elevation of `settings`.
  ClipExtent(const CameraSettings& settings, const Positions& rest);

  void add(const Positions& frame);  // #V x 3
  /// Adds all frames of another clip of the same mesh and settings.
  void join(const ClipExtent& other);

  /// The outermost points of all frames, #points x 3: fit_camera and bounds_of give for them what they would
  /// give for the frames.
  const Positions& outline() const { return outline_; }
  /// Of a vertex from rest, in any frame, mesh units.
  double largest_offset() const { return largest_offset_; }

 private:
  void keep_outermost(const Positions& points);

  std::vector<Eigen::Matrix<double, 3, 2>> planes_;  // in which points are outermost, by two axes each
  Positions rest_;
  Positions outline_{0, 3};
  double largest_offset_ = 0;
};

}  // namespace flexkey
