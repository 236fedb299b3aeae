#pragma once

#include <vector>

#include "flexkey/gltf/primitives.h"
#include "flexkey/gltf/textures.h"
#include "flexkey/mesh/mesh.h"

namespace tinygltf {
class Model;
}

namespace flexkey {

/// Gives the model one material a primitive, in the primitives' order, and the images that they show.
void append_materials(tinygltf::Model& model, const Mesh& mesh, const std::vector<Primitive>& primitives,
                      const TextureSet& textures);

/// A colour channel in linear light, 0..1, of one in sRGB, which is held to 0..1 first (IEC 61966-2-1).
double linear_from_srgb(double channel);

/// The way back: a channel in sRGB of one in linear light, which is held to 0..1 first.
double srgb_from_linear(double channel);

}  // namespace flexkey
