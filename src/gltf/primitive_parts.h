#pragma once

#include "flexkey/gltf/gltf_scene.h"
#include "flexkey/gltf/graft.h"
#include "flexkey/gltf/read_accessor.h"
#include "flexkey/gltf/split_faces.h"

namespace tinygltf {
class Model;
}

namespace flexkey {

/// The side's faces with vertices of their own: appends its triangles to the model, and of every attribute
/// the rows that they name, byte for byte.
PrimitivePart compact_part(tinygltf::Model& model, const GltfPrimitive& primitive, const SplitSide& side,
                           const AccessorReader& reader);

/// The side's faces with the file's own vertices: appends its triangles alone.
PrimitivePart sharing_part(tinygltf::Model& model, const GltfPrimitive& primitive, const SplitSide& side);

}  // namespace flexkey
