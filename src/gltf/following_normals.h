#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "flexkey/gltf/read_gltf.h"
#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// A file's own normals, carried along by its surface: hard edges stay hard and edited normals stay edited.
///
/// Vertices at one place with one normal belong together, whatever texture coordinates part them. Each of the
/// triangles around them turns the file's normal as it has turned itself; the normal of the pose is the mean
/// of what they say, weighted by their area.
class FollowingNormals {
 public:
  /// mesh, source: as read_gltf gives them; all faces are triangles.
  FollowingNormals(const Mesh& mesh, const GltfSource& source);

  /// The normals at these positions of the mesh's vertices, in each node's space, #V x 3. Where no triangle
  /// has moved they are the file's own to the last bit; zeros where it has none.
  Positions at(const Positions& positions) const;

 private:
  /// What takes a node's normals to the scene and back, up to their length.
  struct NodeSpace {
    Eigen::Matrix3d to_scene, to_node;
  };
  using Triangle = std::array<int, 3>;

  std::vector<Triangle> triangles_;
  Positions rest_;                 // #V x 3
  Positions normals_;              // #V x 3, the file's
  std::vector<NodeSpace> spaces_;  // #nodes
  std::vector<int> node_of_;       // #V
  std::vector<int> set_of_;        // #V, the set of vertices that each belongs to
  Positions set_normals_;          // #sets x 3, scene space
};

}  // namespace flexkey
