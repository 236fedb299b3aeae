#pragma once

#include "quad_mesh.h"

namespace flexkey::meshes {

// One step of Catmull-Clark subdivision of a closed mesh; parts and mirror maps carry over.
QuadMesh subdivided(const QuadMesh& mesh);

}  // namespace flexkey::meshes
