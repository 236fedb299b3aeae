#pragma once

#include <functional>
#include <string>

#include "flexkey/timeline/motion.h"

namespace flexkey {

/// Files that a timeline names beside its mesh. The reader of a timeline opens none itself: these do, for
/// paths as the timeline gives them. Each throws Error where it cannot.
struct Sources {
  std::function<std::string(const std::string& path)> text = {};
  /// How an animated node moves, relative to its first sample.
  std::function<MotionTracks(const std::string& path, const std::string& node)> node_motion = {};
};

/// Refuses every file.
Sources no_sources();

}  // namespace flexkey
