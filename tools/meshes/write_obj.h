#pragma once

#include "quad_mesh.h"

#include <map>
#include <string>

namespace flexkey::meshes {

using Colour = std::array<double, 3>;

// Writes DIR/NAME.obj and DIR/NAME.mtl; parts become groups and materials. A part without a
// material of its own takes the one of its group; colours go by material, grey when absent.
void write_obj(const QuadMesh& mesh, const std::string& dir, const std::string& name,
               const std::map<std::string, Colour>& colours);

}  // namespace flexkey::meshes
