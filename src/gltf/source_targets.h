#pragma once

#include <functional>
#include <string>
#include <vector>

#include "flexkey/gltf/float_rows.h"
#include "flexkey/gltf/graft.h"
#include "flexkey/gltf/read_gltf.h"

namespace flexkey {

/// New morph targets of a mesh that came from a glTF file, and how they are played.
struct SourceTargets {
  std::vector<std::string> names;                          // #targets
  std::function<Positions(std::size_t target)> positions;  // deltas in scene space, #V x 3
  std::function<Positions(std::size_t target)> normals;    // deltas in each node's space; none: no normals
  FloatRows times;                                         // #keys x 1, seconds
  FloatRows weights;                                       // #keys x #targets
};

/// Where the animation goes.
struct AnimationPlace {
  std::string name;        // of a new one
  std::string merge_into;  // name of one that stands in the file, instead; empty: a new one
};

/// What the targets add to the file. Each is brought to the space of its node; targets carry the attributes
/// that those of the file carry, and normals where the file's primitive does. The weights of the file's own
/// targets stay as they are: channels that lead them get zeros for the new ones, and in the new animation
/// they have their default. Throws InputError for a `merge_into` that no animation is called.
Addition make_addition(const GltfSource& source, const SourceTargets& targets, const AnimationPlace& place);

}  // namespace flexkey
