#pragma once

#include "flexkey/mesh/mesh.h"

namespace flexkey::bench {

/// A closed, bumpy, irregular surface of about unit radius: the points of an octahedron's grid are strewn
/// over the sphere, joined by their Delaunay triangulation, and moved in and out by smooth noise. size: cells
/// along an octahedron's edge; 4 size² + 2 vertices. The same on every machine.
Mesh make_blob(int size);

}  // namespace flexkey::bench
