#include "cli/timeline_files.h"

#include <fmt/format.h>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey::cli {

Sources sources_of(TimelineFiles& files) {
  const auto text = [&files](const std::string& path) {
    files.paths.push_back(files.folder / path);
    return files.contents.emplace_back(read_file(files.paths.back()));
  };
  const auto node_motion = [](const std::string& path, const std::string& node) -> MotionTracks {
    throw InputError(
        fmt::format("the motion of node '{}' in '{}' cannot be read yet; a 'csv' can", node, path));
  };
  return {text, node_motion};
}

}  // namespace flexkey::cli
