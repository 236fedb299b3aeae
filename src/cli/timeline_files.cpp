#include "cli/timeline_files.h"

#include <vector>

#include "flexkey/gltf/node_motion.h"
#include "flexkey/mesh/read_file.h"
#include "flexkey/timeline/motion_table.h"

namespace flexkey::cli {

Sources sources_of(TimelineFiles& files) {
  const auto text = [&files](const std::string& path) {
    files.paths.push_back(files.folder / path);
    return files.contents.emplace_back(read_file(files.paths.back()));
  };
  const auto node_motion = [&files](const std::string& path, const std::string& node) {
    files.paths.push_back(files.folder / path);
    files.contents.push_back(read_file(files.paths.back()));
    std::vector<MotionSample> samples;
    for (const NodeSample& sample : read_node_motion(files.paths.back(), node))
      samples.push_back({sample.time, sample.translation, sample.rotation, sample.scale});
    return relative_tracks(samples);
  };
  return {text, node_motion};
}

}  // namespace flexkey::cli
