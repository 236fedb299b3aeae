#pragma once

#include <string>
#include <vector>

#include "flexkey/gltf/glb.h"
#include "flexkey/gltf/handle_nodes.h"
#include "flexkey/gltf/measure.h"
#include "flexkey/gltf/split_note.h"

namespace flexkey {

/// A file in memory, and what is to be said of it.
struct Built {
  Glb glb;
  PlaybackError error;
  double pose_error = 0;                // of poses at a weight of 1, a share of the diagonal
  int targets = 0;                      // new ones
  int keys = 0;                         // times at which weights are given
  int vertices = 0;                     // of all primitives that they could move
  std::vector<SplitNote> splits;        // a mesh each; empty: it was not asked for
  std::vector<PlayedRange> animations;  // one a track
  std::vector<std::string> extensions;  // required
  std::vector<std::string> warnings;
};

}  // namespace flexkey
