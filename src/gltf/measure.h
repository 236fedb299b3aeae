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

/// How far a file's playback is from the solved frames, over all frames.
struct PlaybackError {
  double largest = 0;        // vertex distance, as a share of the rest mesh's diagonal
  double kg = 0;             // Karni and Gotsman's error, percent: 100 ‖A − Â‖ / ‖A − E(A)‖
  bool has_normals = false;  // whether the next two mean anything
  double normal_mean = 0;    // angle, degrees
  double normal_largest = 0;
};

/// Reads base and targets of the model's mesh 0 back from its buffer, adds each up in floats as a client
/// does, and compares it with the solved frame of its number. The model's primitives are those of
/// `primitives`, in their order.
PlaybackError measure_playback(const tinygltf::Model& model, const Clip& clip,
                               const std::vector<Primitive>& primitives,
                               const std::optional<SeamlessNormals>& normals);

}  // namespace flexkey
