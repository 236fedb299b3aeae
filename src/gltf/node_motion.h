#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

#include "flexkey/mesh/error.h"

namespace flexkey {

/// Where a node of a scene is at one time.
struct NodeSample {
  double time = 0;              // seconds
  Eigen::Vector3d translation;  // in the scene's space, as the rest
  Eigen::Quaterniond rotation;  // of a node that is sheared, the rotation nearest to it
  Eigen::Vector3d scale;
};

/// How the node of this name moves, with all nodes above it, in the first animation of the file that moves
/// any of them: a sample at each of the keys, and between them so often that what is linear between samples
/// is the curve that glTF means. Throws InputError that names the file: no such node, or no animation that
/// moves it.
std::vector<NodeSample> read_node_motion(const std::filesystem::path& path, const std::string& node);

/// The same from the file's bytes; `path` stands in messages, and what the file names is looked for beside
/// it.
std::vector<NodeSample> parse_node_motion(const std::string& file, const std::filesystem::path& path,
                                          const std::string& node);

}  // namespace flexkey
