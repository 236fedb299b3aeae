#pragma once

#include <vector>

#include "flexkey/animate/scene.h"
#include "flexkey/preview/renderer.h"
#include "flexkey/timeline/preview_output.h"

namespace flexkey::cli {

/// Marks a shot's handles on its pictures.
class HandleMarks {
 public:
  /// Refers to the scene.
  HandleMarks(const Scene& scene, PreviewOutput::Handles which);

  /// At a time (seconds): the handles and anchors that hold then, and, where a handle is still under way, the
  /// places that it reaches at its next key. posed: #V x 3, the frame.
  Marks at(double time, const Positions& posed) const;
  /// All handles and anchors, whether they hold or not, without their targets.
  Marks of_all() const;

 private:
  /// The vertices of a handle that are marked.
  struct Marked {
    std::vector<int> rows;           // in SceneHandle::vertices
    std::vector<int> file_vertices;  // #rows
  };
  Positions targets_ahead(std::size_t handle, double time, const Positions& posed) const;

  const Scene& scene_;
  double diagonal_;
  std::vector<Marked> marked_;  // #handles
};

}  // namespace flexkey::cli
