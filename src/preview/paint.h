#pragma once

#include "flexkey/preview/drawn_frame.h"

namespace flexkey {

/// What colours may tell of a whole frame.
struct Told {
  double lambda = 0.5;
  bool converged = true;
};

/// The colours of a style, but for those of each vertex. Refers to the mesh and the options.
Paint paint_of(const Mesh& mesh, const RenderOptions& options, const Told& told);

/// A colour for each row of `offsets` by its length, the map's last one at `top`.
std::vector<Rgb> displacement_colours(const Points& offsets, float top);

}  // namespace flexkey
