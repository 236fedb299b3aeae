#pragma once

#include <string>

#include "flexkey/timeline/parse.h"
#include "support/meshes.h"

namespace flexkey::test {

/// A shot of this text, as if it stood in shot.yaml.
inline Shot shot_of(const std::string& text) {
  return parse_shot(text, "shot.yaml").shot;
}

/// The lines that every shot of the tests begins with: the bottom of a bar is held.
inline const std::string held_bar =
    "mesh: bar.obj\n"
    "handles:\n"
    "  base: {select: {axis: z, below: 0%}}\n";

/// Two bars that do not touch, one above the other.
inline Mesh two_bars() {
  Mesh upper = meshes::bar(1, 1, 3);
  upper.positions.col(2).array() += 4;
  return meshes::joined(meshes::bar(1, 1, 3), upper);
}

}  // namespace flexkey::test
