#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "flexkey/animate/clip.h"

namespace flexkey {

/// What all frames of one cache have in common.
struct CacheShape {
  std::string name;                  // the shot's
  const Mesh& mesh;                  // the rest mesh; outlives the sink
  double fps = 24;                   // frames a second
  std::vector<int> frames;           // the numbers of the frames to come, increasing, at least one
  std::vector<std::string> handles;  // #handles, names
  enum class Up { y, z };
  Up up = Up::y;  // the mesh's upward axis
};

/// Takes the frames of one clip as they are solved and writes them at once, so that no more than one is in
/// memory. A file gets its name only when it is whole: a frame's own file within `add`, a file of all frames
/// in `finish`; without `finish` the latter is gone with the sink. Every function throws OutputError, with
/// the file's name, for what cannot be written: a full disk, a coordinate that is no finite number.
struct FrameSink {
  std::function<void(const SolvedFrame&)> add;  // the frames of CacheShape::frames, in their order
  std::function<std::uintmax_t()> finish;       // after the last frame; the bytes of all files
};

/// Where a sequence puts frame k.
using FramePath = std::function<std::filesystem::path(int frame)>;

}  // namespace flexkey
