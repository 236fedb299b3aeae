#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "flexkey/gltf/asset.h"
#include "flexkey/gltf/basis.h"
#include "flexkey/gltf/split_asset.h"
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

/// What a client shows of an attribute at some weights, 1 x #targets: #rows x 3.
using Player = std::function<Positions(const Eigen::RowVectorXf& weights)>;

/// An attribute of some vertices as a file plays it. What the player needs is only read back once it is made.
struct PlayedAttribute {
  std::vector<int> vertices;  // of the clip's mesh, one a row
  std::function<Player()> player;
};

/// What a file plays.
struct Played {
  PlayedAttribute positions;  // in the clip's space
  PlayedAttribute normals;    // no vertices where there are none
  NormalsAt solved_normals;   // what they are compared with
};

/// Of the model's meshes, which are those of the split: base and targets read back from its buffer and added
/// up in floats as clients do.
Played played_by(const tinygltf::Model& model, const Asset& asset, const AssetSplit& split);

/// Compares what is played with the weights that the basis gives and the solved clip: at every frame, and
/// positions also at the keys in between, where solved frames are blended linearly. Since file and clip both
/// go straight from one of these times to the next, nothing plays farther off. Takes a step a frame, and one
/// more with normals.
PlaybackError measure_playback(const Played& played, const Clip& clip, const Basis& basis, Steps& steps);

}  // namespace flexkey
