#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "flexkey/gltf/float_rows.h"
#include "flexkey/gltf/gltf_scene.h"
#include "flexkey/gltf/read_gltf.h"

namespace flexkey::testing {

/// A primitive of a node as a client has it in the scene; normals are in the node's space, skins in their
/// bind pose.
struct ShownPrimitive {
  int node = 0;
  FloatRows rest, positions;  // #V x 3
  FloatRows rest_normals, normals;
  std::vector<std::array<int, 3>> triangles;
  bool has_targets = false;
};

/// A file of any profile, as it plays its first animation's weights.
class ShownFile {
 public:
  explicit ShownFile(const std::filesystem::path& path);
  /// All primitives of all nodes at a time, seconds.
  std::vector<ShownPrimitive> at(float seconds) const;
  const GltfScene& scene() const { return scene_; }

 private:
  Eigen::RowVectorXf weights_of(int node, float seconds) const;

  GltfFile file_;
  GltfScene scene_;
};

/// The corners of every triangle at rest and as shown, 9 numbers each, in order of those at rest.
std::vector<std::pair<std::array<float, 9>, std::array<float, 9>>> triangles_of(
    const std::vector<ShownPrimitive>& shown);

}  // namespace flexkey::testing
