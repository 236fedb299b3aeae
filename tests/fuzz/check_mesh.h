#pragma once

#include "flexkey/mesh/mesh.h"

namespace flexkey::fuzz {

/// Ends the program where a reader's mesh is not sound in itself, and does with it what is done with any.
void check_mesh(const Mesh& mesh);

}  // namespace flexkey::fuzz
