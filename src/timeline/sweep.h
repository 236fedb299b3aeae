#pragma once

#include <string>
#include <vector>

#include "flexkey/timeline/findings.h"
#include "flexkey/timeline/node.h"
#include "flexkey/timeline/shot.h"
#include "flexkey/timeline/sources.h"

namespace flexkey {

/// A value that a run of a sweep gives a key, as a `--set` would.
struct SweptNode {
  SweptValue named;
  Mark where;  // of the key
  Node value;
};

/// The runs that a timeline's `sweep` asks for.
struct SweepPlan {
  std::vector<std::vector<SweptNode>> runs;  // a run each; without a sweep one that sets nothing
  std::vector<Note> notes = {};              // of each, what its findings at a place say besides

  Note note_of(std::size_t run) const { return run < notes.size() ? notes[run] : Note{}; }
};

/// Takes the key `sweep` out of the tree: lists of values by key path, of which every combination is a run
/// (the last key's values change fastest), or {csv: file} with key paths in its first line and a run in each
/// other.
SweepPlan take_sweep(Node& root, const Sources& sources, Findings& findings);

}  // namespace flexkey
