#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "flexkey/preview/camera.h"
#include "flexkey/preview/colour.h"

namespace flexkey {

/// What the colours of the surface say.
enum class Style {
  clay,          // nothing: form alone
  normals,       // directions as the camera sees them, x y z as red green blue
  displacement,  // distance from rest
  lambda,        // λ of the vertices
  error,         // clay, and red where the solver has not converged
  wire,          // clay, with the edges of the file's polygons
  textured,      // the file's base colours
};

enum class Quality {
  draft,  // z-buffer: one sample a pixel, hard shadows
  final,  // traced: soft shadows, ambient occlusion, anti-aliasing
};

/// Base colour of a material (index in Mesh::materials) at texture coordinates, v upwards as in OBJ. Called
/// from several threads.
using TextureLookup = std::function<Rgb(int material, const Eigen::Vector2f& uv)>;

/// What does not change from frame to frame.
struct RenderOptions {
  int width = 960, height = 540;  // pixels
  int samples = 8;                // a pixel, for Quality::final
  int subdivide = 2;              // level, 0..4
  Style style = Style::clay;
  Quality quality = Quality::final;
  Up up = Up::y;
  std::optional<double> floor;  // height of the ground, mesh units; default: the lowest point of the bounds
  double weld = 0;              // vertices at most this far apart are one, mesh units, as for the solver
  double displacement_top =
      0;                       // share of the diagonal that has the map's last colour; see displacement_top()
  TextureLookup texture = {};  // without it Style::textured shows the materials' colours
};

/// Throws InputError for sizes, samples or a level that cannot be rendered.
void check_options(const RenderOptions& options);

}  // namespace flexkey
