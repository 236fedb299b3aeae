#include "fuzz/targets.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

namespace flexkey::fuzz {

std::span<const Target> targets() {
  static constexpr std::array all{
      Target{"timeline", run_timeline, no_seeds},
      Target{"cues", run_cues, no_seeds},
      Target{"table", run_table, no_seeds},
      Target{"obj", run_obj, no_seeds},
      Target{"mtl", run_mtl, no_seeds},
      Target{"ply", run_ply, ply_seeds},
      Target{"off", run_off, no_seeds},
      Target{"stl", run_stl, stl_seeds},
      Target{"glb", run_glb, glb_seeds},
      Target{"motion", run_motion, motion_seeds},
      Target{"checkpoint", run_checkpoint, checkpoint_seeds},
      Target{"frames", run_frames, frames_seeds},
  };
  return all;
}

const Target* find_target(std::string_view name) {
  const auto all = targets();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Target& target) { return target.name == name; });
  return found == all.end() ? nullptr : &*found;
}

void promise(bool holds, std::string_view what) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}

std::vector<std::string> no_seeds() {
  return {};
}

}  // namespace flexkey::fuzz
