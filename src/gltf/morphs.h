#pragma once

#include <optional>
#include <vector>

#include "flexkey/animate/clip.h"
#include "flexkey/gltf/primitives.h"
#include "flexkey/gltf/shape.h"

namespace tinygltf {
class Model;
}

namespace flexkey {

/// Appends mesh 0: the rest mesh as its base and one morph target a frame, target k being frame k, all
/// weights 0. Every target of every primitive carries POSITION, and NORMAL with normals, even where nothing
/// moves: three.js and Babylon want the same attributes in all of them.
void append_morph_mesh(tinygltf::Model& model, const Clip& clip, const std::vector<Primitive>& primitives,
                       const std::optional<SeamlessNormals>& normals);

/// Appends animation 0: the weights of node 0's mesh over time, LINEAR keys at k / fps from 0, key k giving
/// target k the weight 1 and all others 0.
void append_weights_animation(tinygltf::Model& model, const Clip& clip);

}  // namespace flexkey
