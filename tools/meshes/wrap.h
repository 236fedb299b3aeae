#pragma once

#include "implicit.h"
#include "quad_mesh.h"

namespace flexkey::meshes {

struct WrapOptions {
  int rounds = 20;         // rounds of relaxing and projecting
  double relax = 0.5;      // share of the way to the relaxed place, a round
  double square = 0.5;     // how much the relaxed place makes quads square rather than even
  double hold = 0.1;       // pull back to where the vertex started
  double max_step = 0.05;  // longest move towards the surface a round
};

// Shrink-wraps the mesh onto the clay while sliding its vertices along the surface to even quads.
void wrap(QuadMesh& mesh, const Clay& clay, const WrapOptions& options);

// Moves each vertex onto the clay, without sliding.
void project(QuadMesh& mesh, const Clay& clay, int rounds, double max_step);

}  // namespace flexkey::meshes
