#pragma once

#include <string>
#include <variant>
#include <vector>

#include "flexkey/gltf/graft.h"
#include "flexkey/gltf/measure.h"
#include "flexkey/gltf/quantize.h"
#include "flexkey/gltf/read_gltf.h"
#include "flexkey/gltf/split_source.h"
#include "flexkey/gltf/targets.h"
#include "flexkey/gltf/weight_tracks.h"

namespace tinygltf {
class Model;
}

namespace flexkey {

/// What a clip adds to the file of its mesh.
struct SourceTargets {
  std::vector<std::string> names;                        // #targets
  std::variant<MorphTargets, QuantizedTargets> targets;  // of #V rows, in the space of each vertex's node
  SourceSplit split;                                     // which of its faces get them
  bool normals = true;              // else the file's own are dropped: clients shade flat
  std::vector<WeightTrack> tracks;  // an animation each
  std::string merge_into;  // an animation of the file that gets the first track's weights; empty: all are new
};

/// Appends the targets' accessors to the model, and says what else is to be done for them: targets carry the
/// attributes that those of the file carry, and normals where the file's primitive does; the weights of the
/// file's own targets stay as they are, which in a new animation means their defaults.
/// Throws InputError for a `merge_into` that no animation is called.
Addition add_targets(tinygltf::Model& model, const GltfSource& source, const SourceTargets& targets);

}  // namespace flexkey
