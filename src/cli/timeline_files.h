#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "flexkey/timeline/sources.h"

namespace flexkey::cli {

/// The files that a timeline names for motions and cues: where they lie, and what they say.
struct TimelineFiles {
  std::filesystem::path folder;  // the timeline's
  std::vector<std::filesystem::path> paths;
  std::vector<std::string> contents;  // of each
};

/// Reads files into `files`, which has to outlive it.
Sources sources_of(TimelineFiles& files);

}  // namespace flexkey::cli
