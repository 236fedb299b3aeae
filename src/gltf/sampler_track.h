#pragma once

#include <string>
#include <vector>

#include "flexkey/gltf/float_rows.h"

namespace flexkey {

/// The weights of a mesh's targets over time, as a glTF sampler has them.
struct SamplerTrack {
  std::string interpolation = "LINEAR";  // or "STEP" or "CUBICSPLINE"
  FloatRows times;                       // #keys x 1, seconds, increasing
  FloatRows values;  // #keys x #targets; CUBICSPLINE: in-tangent, value, out-tangent a key
};

/// The track with `count` targets more, whose weights stay 0.
SamplerTrack padded(const SamplerTrack& track, Eigen::Index count);

/// All weights at a time, 1 x #targets; before the first key and after the last its value holds.
Eigen::RowVectorXf sample(const SamplerTrack& track, float time);

/// Both tracks' targets, those of `first` before those of `second`, with a LINEAR key at every key of either.
/// What lies between keys is the tracks' own where they are LINEAR; a STEP of `first` becomes a ramp from
/// just before its key.
SamplerTrack side_by_side(const SamplerTrack& first, const SamplerTrack& second);

}  // namespace flexkey
