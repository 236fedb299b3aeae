#pragma once

#include <string>

#include "flexkey/gltf/graft.h"
#include "flexkey/gltf/measure.h"
#include "flexkey/gltf/read_gltf.h"
#include "flexkey/gltf/split_source.h"

namespace tinygltf {
class Model;
}

namespace flexkey {

/// A file with a clip in it. All of it has to outlive what is played of it.
struct ExtendedSource {
  const GltfSource& source;
  const SourceSplit& split;
  const Addition& addition;
  const tinygltf::Model& model;  // with the addition's accessors
};

/// "POSITION" in the scene's space, or "NORMAL" of the primitives that have it in their nodes' space, as
/// clients add them up.
PlayedAttribute played_by(const ExtendedSource& file, const std::string& semantic);

}  // namespace flexkey
