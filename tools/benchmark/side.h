#pragma once

#include <functional>

#include "flexkey/deform/deformer.h"

namespace flexkey::bench {

/// One of the two libraries on a mesh and its constraints. It keeps of the mesh what it needs itself.
struct Side {
  std::function<void()> set_up;                      // what is paid once for a set of constraints
  std::function<SolveReport(const Targets&)> solve;  // the next frame, from the one before
  std::function<Positions()> positions;              // #V x 3, after the last frame
};

/// flexkey's Deformer with one λ for the surface.
Side flexkey_side(Mesh mesh, Constraints constraints, const DeformOptions& options, double lambda);

/// CGAL's Surface_mesh_deformation (ORIGINAL_ARAP) with its default solver and rotation fit, a fixed number
/// of iterations a frame. The mesh is made of triangles.
Side cgal_side(const Mesh& mesh, const Constraints& constraints, int iterations);

}  // namespace flexkey::bench
