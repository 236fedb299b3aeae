#pragma once

#include <string>

#include "flexkey/animate/clip.h"
#include "flexkey/gltf/measure.h"
#include "flexkey/gltf/primitives.h"

namespace tinygltf {
class Value;
}

namespace flexkey {

/// "f0042": the name of the morph target of frame 42.
std::string target_name(int frame);

/// What a mesh and an animation say of their origin: profile, fps, frames, the source frame and λ of each
/// target, the hash of timeline and mesh, and the measured errors.
tinygltf::Value describe_clip(const Clip& clip, const std::string& hash, const PlaybackError& error);

/// `groups`: the groups of the mesh as [first, count, first, count, …] of the primitive's triangles; no value
/// (null) where none of its faces is in a group.
tinygltf::Value describe_groups(const Mesh& mesh, const Primitive& primitive);

}  // namespace flexkey
