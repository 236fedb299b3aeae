#pragma once

#include "flexkey/gltf/glb.h"

namespace flexkey {

/// The same asset with every buffer view that an accessor reads whole encoded by EXT_meshopt_compression,
/// which then is required to read it: attributes by vertex codec version 0, triangles by index codec
/// version 1, floats on a common grid of a power of two with the filter EXPONENTIAL. Nothing is lost. Views
/// that it cannot hold, or that would not get smaller, stay as they are.
Glb meshopt_compressed(const Glb& glb);

}  // namespace flexkey
