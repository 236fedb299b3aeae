#pragma once

#include "flexkey/animate/clip.h"
#include "flexkey/gltf/basis.h"
#include "flexkey/gltf/measure.h"
#include "flexkey/gltf/primitives.h"
#include "flexkey/gltf/write_glb.h"

namespace tinygltf {
class Model;
class Value;
}  // namespace tinygltf

namespace flexkey {

/// Fills asset, and the extras of mesh 0 and of every animation: profile, tolerance, fps, frames and their λ,
/// the source frame of each key, target names, the hash of timeline and mesh, and the measured errors.
void describe(tinygltf::Model& model, const Clip& clip, const Basis& basis, const GltfOptions& options,
              const PlaybackError& error);

/// `groups`: the groups of the mesh as [first, count, first, count, …] of the primitive's triangles; no value
/// (null) where none of its faces is in a group.
tinygltf::Value describe_groups(const Mesh& mesh, const Primitive& primitive);

}  // namespace flexkey
