#pragma once

#include <string>
#include <vector>

#include "flexkey/mesh/weld.h"

namespace flexkey::cli {

/// A part of a mesh that a starter timeline holds or leads.
struct StarterPart {
  std::string name;           // of the handle, unique
  std::string select;         // as a timeline writes it
  std::vector<int> vertices;  // that it takes, of the surface
};

/// A part that swings about a joint inside the mesh.
struct StarterTip {
  StarterPart part;
  Vec3 joint;        // mesh units
  Vec3 axis;         // unit, about which it turns
  double angle = 0;  // degrees, the widest
};

/// What a starter timeline does with a mesh.
struct Starter {
  StarterPart base;              // held
  std::vector<StarterTip> tips;  // at least one; no vertex is in two parts
};

/// Finds something to hold and something to move: the low end of the largest component (y is up; of a long or
/// flat shape one of its far ends), and the parts that stick out farthest from it along the principal axes. A
/// group or node that has such an end in it is taken whole; otherwise what lies around the end, along the
/// surface. Throws InputError for a mesh without a surface to move.
Starter propose_starter(const Weld& weld, const std::string& mesh_name);

}  // namespace flexkey::cli
