#pragma once

#include <vector>

#include "flexkey/gltf/asset.h"
#include "flexkey/gltf/quantize.h"
#include "flexkey/gltf/targets.h"
#include "flexkey/gltf/weight_tracks.h"

namespace tinygltf {
class Model;
}

namespace flexkey {

/// Appends mesh 0, the moving primitives: the rest shape as its base and the targets, all of weight 0. Every
/// target of every primitive carries POSITION, and NORMAL with normals, even where nothing moves: three.js
/// and Babylon want the same attributes in all of them. The targets are taken apart as they are written.
void append_morph_mesh(tinygltf::Model& model, const Asset& asset, const std::vector<Primitive>& moving,
                       MorphTargets targets);

/// The same with targets in integers of two bytes for positions (KHR_mesh_quantization).
void append_morph_mesh(tinygltf::Model& model, const Asset& asset, const std::vector<Primitive>& moving,
                       const QuantizedTargets& targets);

/// Appends a mesh of the rest shape alone.
void append_still_mesh(tinygltf::Model& model, const Asset& asset, const std::vector<Primitive>& still);

/// Appends an animation of the weights of node 0.
void append_weights_animation(tinygltf::Model& model, const WeightTrack& track);

}  // namespace flexkey
