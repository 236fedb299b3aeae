#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "flexkey/gltf/basis.h"
#include "flexkey/gltf/write_glb.h"

namespace flexkey {

/// Weights of a mesh's targets over time.
struct WeightTrack {
  std::string name;           // of the animation
  std::vector<double> times;  // #keys, seconds, strictly increasing from 0
  Eigen::MatrixXf weights;    // #keys x #targets, LINEAR between keys
  double from = 0, to = 0;    // the part of the shot that it plays, seconds
};

/// One track a range, each from 0, or one of the whole clip under the clip's name. A range that lies
/// outside the clip is cut to it. A clip that comes round ends with its first weights. Throws InputError
/// where nothing of it is left.
std::vector<WeightTrack> weight_tracks(const Clip& clip, const Basis& basis,
                                       const std::vector<ClipRange>& ranges);

/// The animations that the options ask for.
std::vector<WeightTrack> tracks_of(const Clip& clip, const Basis& basis, const GltfOptions& options);

}  // namespace flexkey
