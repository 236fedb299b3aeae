#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "flexkey/mesh/error.h"

namespace flexkey {

/// What a file of cues has to say at a time.
struct Cue {
  double time = 0;  // seconds
  std::string name;
};

/// The lines of a cue file: a time as in a timeline ("1.5", "1.5s", "36f") and a name, with tabs or spaces
/// between; "#" begins a comment. Increasing times. Throws InputError with the line.
std::vector<Cue> cues_of(std::string_view text, double fps);

}  // namespace flexkey
