#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "flexkey/gltf/glb.h"
#include "flexkey/mesh/error.h"
#include "flexkey/mesh/mesh_file.h"

namespace flexkey {

/// A primitive of a solved mesh: vertex v of its accessors is vertex first_vertex + v of the Mesh. Primitives
/// of a node that share their accessors share the vertices too.
struct SolvedPrimitive {
  int first_vertex = 0;
  int vertex_count = 0;
  bool has_normals = false;
};

/// A node whose mesh is solved.
struct SolvedNode {
  int node = 0, mesh = 0;  // indices of the file
  std::string name;
  Eigen::Matrix4d world;  // from the space of its accessors to the scene's; of a skinned mesh the identity
  std::vector<SolvedPrimitive> primitives;  // #primitives of the mesh
};

/// Where a mesh came from, for writing it back.
struct GltfSource {
  Glb document;                         // the whole file
  std::vector<SolvedNode> nodes;        // in the file's order
  std::vector<std::string> animations;  // names of all, as they stand in the file
  Positions normals;  // #V x 3, the file's normals in each node's space; zeros where it has none
};

struct GltfFile {
  MeshFile file;
  GltfSource source;
};

/// A name among `names` that no node bears.
class UnknownNodeError : public InputError {
 public:
  UnknownNodeError(std::size_t which, const std::string& message) : InputError(message), which_(which) {}
  std::size_t which() const { return which_; }

 private:
  std::size_t which_;
};

/// Reads a .glb or .gltf file: the meshes of the named nodes, or of all nodes of the default scene where none
/// is named, as one mesh in scene space. A name stands for every node that bears it (or whose mesh does), and
/// for the meshes below one without a mesh of its own.
///
/// Vertices are the accessors' own: node after node, primitive after primitive. Seams between nodes, which
/// rounding tears apart, are closed where they gape by at most 1e-6 of the diagonal. Every node is a group of
/// its name. Skinned meshes are in their bind pose, which knows no node's transform. Points and lines give
/// vertices without faces.
///
/// Throws InputError with the file's name and the thing that is wrong, UnknownNodeError for a name.
GltfFile read_gltf(const std::filesystem::path& path, const std::vector<std::string>& names = {});

/// The same from the file's bytes; `path` stands in messages, and what the file names is looked for beside
/// it.
GltfFile parse_gltf(const std::string& file, const std::filesystem::path& path,
                    const std::vector<std::string>& names = {});

}  // namespace flexkey
