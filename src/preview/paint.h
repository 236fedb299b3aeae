#pragma once

#include "flexkey/preview/drawn_frame.h"

namespace flexkey {

/// Whether the solver has reached the frame's shape.
enum class Solve { converged, unfinished };

/// The colours of a style, but for those of each vertex. Refers to the mesh and the options.
Paint paint_of(const Mesh& mesh, const RenderOptions& options, Solve solve);

/// A colour for each row of `offsets` by its length, the map's last one at `top`.
std::vector<Rgb> displacement_colours(const Points& offsets, float top);

/// A colour for each λ of a vertex.
std::vector<Rgb> lambda_colours(const Eigen::VectorXf& lambda);

}  // namespace flexkey
