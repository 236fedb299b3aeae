#pragma once

#include <vector>

#include "flexkey/gltf/read_gltf.h"
#include "flexkey/gltf/split_faces.h"
#include "flexkey/gltf/split_note.h"

namespace flexkey {

/// What becomes of a primitive of a file.
struct PrimitiveSplit {
  enum class Fate {
    moves,  // it gets targets, as it is
    stays,  // it gets none
    parts,  // faces that move get vertices of their own, those that stay (if any do) keep the file's
  };
  Fate fate = Fate::moves;
  SplitFaces faces;  // of one that parts
};

/// What becomes of the solved nodes of a file.
struct SourceSplit {
  std::vector<std::vector<PrimitiveSplit>> nodes;  // #nodes of #primitives
  std::vector<SplitNote> notes;                    // #nodes
};

/// Every node whole.
SourceSplit whole(const GltfSource& source);

/// Parts faces that never move from those that do, node by node, where that is worth it. A mesh with targets
/// of its own stays whole. moved: see moved_vertices.
SourceSplit split_source(const GltfSource& source, const std::vector<bool>& moved);

/// The clip's vertices that get targets of such a primitive, in the order of its rows.
std::vector<int> moving_rows(const SolvedPrimitive& primitive, const PrimitiveSplit& split);

/// Those that get none, likewise.
std::vector<int> still_rows(const SolvedPrimitive& primitive, const PrimitiveSplit& split);

/// Whether any of the node's primitives gets targets.
bool moves(const std::vector<PrimitiveSplit>& primitives);

}  // namespace flexkey
