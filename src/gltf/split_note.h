#pragma once

#include <string>

namespace flexkey {

/// What `split` made of a mesh.
struct SplitNote {
  std::string mesh;       // its name
  int vertices = 0;       // of all of its primitives
  int moved = 0;          // that a target ever moves or turns
  int targeted = 0;       // that carry targets: all, or where it is split those that the moving faces name
  std::string why_whole;  // empty: it is split
};

/// The note of a mesh whose moving faces name `targeted` vertices: it is split where under half of its
/// vertices move and that leaves some without targets.
SplitNote decide_split(SplitNote note);

/// The same mesh, not split for this reason.
SplitNote left_whole(SplitNote note, const std::string& why);

/// What the part of a mesh or node is called that never moves.
std::string still_name(const std::string& name);

}  // namespace flexkey
