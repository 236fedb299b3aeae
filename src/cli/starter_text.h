#pragma once

#include <string>

#include "cli/starter.h"

namespace flexkey::cli {

/// The files that a starter timeline names.
struct StarterFiles {
  std::string mesh;  // as the timeline is to give it
  std::string shot;  // the timeline's own, for its comments
  std::string stem;  // of its outputs: "cow" for cow.glb and cow.html
};

/// A commented timeline that holds and swings the parts. diagonal: of the mesh, its units.
std::string starter_text(const Starter& starter, const Weld& weld, const StarterFiles& files);

}  // namespace flexkey::cli
