#pragma once

#include "implicit.h"
#include "quad_mesh.h"
#include "wrap.h"
#include "write_obj.h"

#include <map>
#include <string>
#include <vector>

namespace flexkey::meshes {

struct Model {
  QuadMesh mesh;
  std::map<std::string, Colour> colours;
};

// Wraps a half cage onto the clay, so that details can be set on its cells where the skin is.
void fit_cage(QuadMesh& half_cage, const Clay& clay, const WrapOptions& options);

// Completes a half cage and refines it, wrapping it onto the clay after each subdivision: `levels`
// holds the options, one set a subdivision.
QuadMesh shaped(const QuadMesh& half_cage, const Clay& clay, const std::vector<WrapOptions>& levels);

Model make_head();
Model make_pig();
Model make_dragon();

// A square bar from z = 0 to `length`, with `across` quads a side of the section.
Model make_bar(double length, Index across, Index along);

}  // namespace flexkey::meshes
