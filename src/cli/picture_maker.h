#pragma once

#include <string>
#include <vector>

#include "cli/frame_spool.h"
#include "cli/load.h"
#include "cli/preview_marks.h"
#include "flexkey/animate/scene.h"
#include "flexkey/preview/images/overlay.h"
#include "flexkey/preview/renderer.h"

namespace flexkey::cli {

/// What all pictures of a shot are made for.
struct Framing {
  Positions outline;          // #points x 3: the picture holds them
  double largest_offset = 0;  // of a vertex from rest in any frame, mesh units: for the scale of its colours
};

/// The run that a frame is of.
struct PictureRun {
  const Shot& shot;
  std::vector<Moment> moments;  // of all its frames, for the overlay
};

/// Draws the pictures of a shot's runs, all with one camera.
class PictureMaker {
 public:
  /// Refers to the shot and the scene.
  PictureMaker(const LoadedShot& loaded, const Scene& scene, const Framing& framing);

  Picture draw(const KeptFrame& frame, const PictureRun& of);
  /// A hash of all that the picture's pixels depend on.
  std::string inputs(const KeptFrame& frame, const PictureRun& of) const;

  /// Whole lines.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  Camera camera_at(int frame) const;
  Marks marks_of(const KeptFrame& frame) const;
  Eigen::VectorXf lambda_of(const KeptFrame& frame, const PictureRun& of) const;

  const LoadedShot& loaded_;
  const Scene& scene_;
  HandleMarks marks_;
  std::vector<std::string> warnings_;
  RenderOptions options_;
  Camera camera_;
  Renderer renderer_;
  std::string always_;  // hash of what all pictures depend on
};

}  // namespace flexkey::cli
