#pragma once

#include <Eigen/Core>

#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// #V, a third of the areas of the triangles at each vertex, file units squared; a polygon's are the mean
/// over its triangle fans, so that the order of its corners does not matter.
Eigen::VectorXd vertex_areas(const Mesh& mesh);

/// #V, one over each vertex's area, in units of the mean: what `area_weighting` scales the squares of eq 7
/// by, so that a region counts by its area and not by how densely it is meshed. Areas count as at least 1e-6
/// of the mean; all 1 on a mesh without area.
Eigen::VectorXd row_weights(const Mesh& mesh);

}  // namespace flexkey
