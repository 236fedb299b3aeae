#pragma once

#include "flexkey/gltf/asset.h"
#include "flexkey/gltf/basis.h"
#include "flexkey/gltf/steps.h"

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

/// Reads base and targets of the model's mesh 0 back from its buffer, adds them up in floats as a client does
/// with the weights that the basis gives them, and compares that with the solved clip: at every frame, and
/// positions also at the keys in between, where solved frames are blended linearly. Since file and clip both
/// go straight from one of these times to the next, nothing plays farther off. steps: advanced
/// once a frame for positions, and once for normals.
PlaybackError measure_playback(const tinygltf::Model& model, const Asset& asset, const Basis& basis,
                               Steps& steps);

}  // namespace flexkey
