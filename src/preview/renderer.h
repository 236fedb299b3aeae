#pragma once

#include <memory>
#include <string>
#include <vector>

#include "flexkey/preview/camera.h"
#include "flexkey/preview/picture.h"
#include "flexkey/preview/render_options.h"

namespace flexkey {

/// What is marked on the surface: the paper's blue, red and green.
struct Marks {
  std::vector<int> handles;  // vertices of the file, drawn blue where the surface has them
  std::vector<int> anchors;  // red
  Positions targets;         // #targets x 3, mesh units, green: where handles are asked to go
};

/// One frame to draw.
struct FrameState {
  const Positions& positions;   // #V x 3, vertices of the file, mesh units
  Eigen::VectorXf lambda = {};  // #V, for Style::lambda; empty: 0.5 everywhere
  bool converged = true;
  Marks marks = {};
  std::vector<Rgb> colours = {};  // #V, of the surface, instead of the style's; empty: as the style has them
};

/// Draws the frames of a clip. Stencils, normals' neighbours and buffers are made once; a frame costs one
/// apply, one tree and its pixels, and leaves nothing behind: its picture is the same alone, in any order and
/// with any number of threads.
class Renderer {
 public:
  /// rest: the file's mesh, which the renderer refers to. bounds: of all frames (bounds_of(frames)).
  /// Throws InputError for options that cannot be rendered, or bounds that
  /// are not finite.
  Renderer(const Mesh& rest, const Bounds& bounds, RenderOptions options);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Throws InputError where the frame does not fit the mesh or a vertex is not finite.
  Picture render(const FrameState& frame, const Camera& camera);

  /// What the user should know, at most one line: why the mesh is not subdivided.
  const std::vector<std::string>& warnings() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace flexkey
