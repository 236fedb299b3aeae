#include "flexkey/gltf/build_mesh.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "flexkey/gltf/primitive_faces.h"
#include "flexkey/gltf/read_accessor.h"
#include "flexkey/mesh/limits.h"
#include "flexkey/mesh/weld.h"

namespace flexkey {
namespace {

// A share of the diagonal: positions are floats, which round by some 1e-7 in each node's own space.
constexpr double kNodeGap = 1e-6;

// Leaves room for differences of two positions within a float's 3.4e38.
constexpr double kFarthest = 1e38;

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

int find(const GltfAttributes& attributes, const char* semantic) {
  const auto found = attributes.find(semantic);
  return found == attributes.end() ? -1 : found->second;
}

/// Rows of one set of accessors.
struct Block {
  Positions positions;  // scene space
  Positions normals;    // the node's space; zeros where there are none
};

/// A custom attribute of one primitive's vertices.
struct PrimitiveAttribute {
  std::string name;
  int first_vertex;
  Eigen::VectorXd values;
};

class Builder {
 public:
  Builder(const GltfScene& scene, std::span<const unsigned char> bytes)
      : scene_(scene), reader_(scene, bytes) {}

  void add(int node, const NodeTree& tree);
  GltfFile finish();

 private:
  SolvedPrimitive add_primitive(const GltfPrimitive& primitive, const SolvedNode& node,
                                const std::string& what);
  int add_vertices(const GltfPrimitive& primitive, const SolvedNode& node, const std::string& what);
  int add_faces(const GltfPrimitive& primitive, const SolvedPrimitive& solved, bool mirrored);
  void add_to_group(const std::string& name, int first_face, int count);
  void note_attributes(const GltfPrimitive& primitive, const SolvedPrimitive& solved,
                       const std::string& what);
  void close_gaps();
  void join_attributes();

  const GltfScene& scene_;
  AccessorReader reader_;
  GltfFile result_;
  std::vector<Block> blocks_;
  limits::MeshSize most_;
  std::size_t group_faces_ = 0;
  int vertex_count_ = 0;
  std::map<std::pair<int, int>, int> first_vertices_;  // of this node, by accessors of positions and normals
  std::map<std::string, std::size_t> groups_;          // place of each by name
  std::vector<PrimitiveAttribute> attributes_;
};

/// Throws for what could not be read, or not be written back with morph targets.
void check_primitive(const GltfScene& scene, const GltfMesh& mesh, const GltfPrimitive& primitive,
                     const std::string& what) {
  constexpr const char *draco = "KHR_draco_mesh_compression", *variants = "KHR_materials_variants";
  for (const std::string& name : primitive.extensions) {
    const bool is_required =
        std::find(scene.required.begin(), scene.required.end(), name) != scene.required.end();
    if (name == draco || (is_required && name != variants))
      throw InputError(fmt::format("{} needs {}, which flexkey cannot read", what, name));
  }
  if (find(primitive.attributes, "POSITION") < 0) throw InputError(fmt::format("{} has no POSITION", what));
  if (primitive.targets.size() != mesh.primitives[0].targets.size())
    throw InputError(fmt::format("{} has {} morph targets, and primitive 0 has {}", what,
                                 primitive.targets.size(), mesh.primitives[0].targets.size()));
}

bool is_invertible(const Eigen::Matrix4d& world) {
  const Eigen::Matrix3d linear = world.topLeftCorner<3, 3>();
  return world.allFinite() && Eigen::FullPivLU<Eigen::Matrix3d>(linear).isInvertible();
}

void Builder::add(int number, const NodeTree& tree) {
  const GltfNode& node = scene_.nodes[index(number)];
  const GltfMesh& mesh = scene_.meshes[index(node.mesh)];
  SolvedNode solved{number, node.mesh, node_name(scene_, number), tree.world(number), {}};
  if (node.skin >= 0) solved.world.setIdentity();  // glTF 2.0 section 3.7.3.3: joints alone place a skin
  if (!is_invertible(solved.world))
    throw InputError(fmt::format("the transform of node {} ('{}') cannot be undone", number, solved.name));

  first_vertices_.clear();
  const int first_face = result_.file.mesh.face_count();
  for (const GltfPrimitive& primitive : mesh.primitives) {
    const std::string what = fmt::format("primitive {} of mesh {}", solved.primitives.size(), node.mesh);
    check_primitive(scene_, mesh, primitive, what);
    solved.primitives.push_back(add_primitive(primitive, solved, what));
  }
  add_to_group(solved.name, first_face, result_.file.mesh.face_count() - first_face);
  result_.source.nodes.push_back(std::move(solved));
}

SolvedPrimitive Builder::add_primitive(const GltfPrimitive& primitive, const SolvedNode& node,
                                       const std::string& what) {
  SolvedPrimitive solved;
  solved.first_vertex = add_vertices(primitive, node, what);
  solved.vertex_count = static_cast<int>(reader_.count(find(primitive.attributes, "POSITION")));
  solved.has_normals = find(primitive.attributes, "NORMAL") >= 0;
  const int first_face = result_.file.mesh.face_count();
  const bool mirrored = node.world.topLeftCorner<3, 3>().determinant() < 0;
  const int faces = add_faces(primitive, solved, mirrored);
  if (faces == 0)
    result_.file.warnings.push_back(
        fmt::format("{} has no triangles; its vertices move only where they lie on the surface's", what));
  note_attributes(primitive, solved, what);
  for (const GltfGroup& group : primitive.groups)
    for (std::size_t run = 0; run + 2 <= group.triangles.size(); run += 2) {
      const int first = std::min(group.triangles[run], faces);
      add_to_group(group.name, first_face + first, std::min(group.triangles[run + 1], faces - first));
    }
  return solved;
}

int Builder::add_vertices(const GltfPrimitive& primitive, const SolvedNode& node, const std::string& what) {
  const int position = find(primitive.attributes, "POSITION"), normal = find(primitive.attributes, "NORMAL");
  const auto [entry, is_new] = first_vertices_.try_emplace({position, normal}, vertex_count_);
  if (!is_new) return entry->second;
  // Nodes may show one mesh many times over, so that a small file could ask for all memory.
  if (reader_.count(position) > most_.vertices - index(vertex_count_))
    throw InputError(fmt::format("its nodes have {}", limits::more_than(most_.vertices, "vertices")));

  const AccessorRows rows = reader_.rows(position, 3);
  const Eigen::Matrix3d linear = node.world.topLeftCorner<3, 3>();
  Block block;
  block.positions = (rows * linear.transpose()).rowwise() + node.world.topRightCorner<3, 1>().transpose();
  if (!(block.positions.array().abs() <= kFarthest).all())
    throw InputError(fmt::format("{} reaches farther than floats do", what));
  block.normals = normal < 0 ? AccessorRows::Zero(rows.rows(), 3) : reader_.rows(normal, 3);
  if (block.normals.rows() != block.positions.rows())
    throw InputError(fmt::format("{} has {} positions and {} normals", what, block.positions.rows(),
                                 block.normals.rows()));
  vertex_count_ += static_cast<int>(rows.rows());
  blocks_.push_back(std::move(block));
  return entry->second;
}

/// How many there are.
int Builder::add_faces(const GltfPrimitive& primitive, const SolvedPrimitive& solved, bool mirrored) {
  Mesh& mesh = result_.file.mesh;
  const std::size_t corner_count =
      primitive.indices < 0 ? index(solved.vertex_count) : reader_.count(primitive.indices);
  if (corner_count > most_.corners - std::min(mesh.corners.size(), most_.corners))
    throw InputError(fmt::format("its nodes have {}", limits::more_than(most_.corners, "corners")));
  std::vector<int> corners(index(solved.vertex_count));
  std::iota(corners.begin(), corners.end(), 0);
  if (primitive.indices >= 0) corners = reader_.indices(primitive.indices, index(solved.vertex_count));

  const std::vector<std::array<int, 3>> triangles = triangles_of_mode(corners, primitive.mode);
  for (std::array<int, 3> triangle : triangles) {
    if (mirrored) std::swap(triangle[1], triangle[2]);
    for (int& vertex : triangle) vertex += solved.first_vertex;
    mesh.add_face(triangle);
    mesh.face_material.push_back(primitive.material);
  }
  return static_cast<int>(triangles.size());
}

/// Custom attributes of one number a vertex; their names begin with '_' (glTF 2.0 section 3.7.2.1).
void Builder::note_attributes(const GltfPrimitive& primitive, const SolvedPrimitive& solved,
                              const std::string& what) {
  for (const auto& [name, accessor] : primitive.attributes) {
    if (!name.starts_with('_') || scene_.accessors[index(accessor)].columns != 1) continue;
    if (reader_.count(accessor) != index(solved.vertex_count))
      throw InputError(fmt::format("{} has {} positions and {} of '{}'", what, solved.vertex_count,
                                   reader_.count(accessor), name));
    attributes_.push_back({name, solved.first_vertex, reader_.rows(accessor, 1).col(0)});
  }
}

/// A value a vertex of the whole mesh; NaN where a primitive has none.
void Builder::join_attributes() {
  std::map<std::string, Eigen::VectorXd> joined;
  for (const auto& [name, first, values] : attributes_) {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    Eigen::VectorXd& all =
        joined.try_emplace(name, Eigen::VectorXd::Constant(vertex_count_, nothing)).first->second;
    all.segment(first, values.size()) = values;
  }
  for (auto& [name, values] : joined) result_.file.mesh.attributes.push_back({name, std::move(values)});
}

void Builder::add_to_group(const std::string& name, int first_face, int count) {
  std::vector<Group>& groups = result_.file.mesh.groups;
  const auto [entry, is_new] = groups_.try_emplace(name, groups.size());
  if (is_new) groups.push_back({name, {}});
  if (index(count) > most_.group_faces - group_faces_)
    throw InputError(fmt::format("its groups have {}", limits::more_than(most_.group_faces, "faces")));
  group_faces_ += index(count);
  for (int face = first_face; face < first_face + count; ++face) groups[entry->second].faces.push_back(face);
}

/// Gives vertices that rounding tore apart between nodes one place.
void Builder::close_gaps() {
  Mesh& mesh = result_.file.mesh;
  if (result_.source.nodes.size() < 2) return;
  const Weld welded = weld(mesh, kNodeGap * bounds_of(mesh.positions).diagonal());
  mesh.positions = scatter(welded, welded.surface.positions);
}

GltfFile Builder::finish() {
  Mesh& mesh = result_.file.mesh;
  if (mesh.face_count() == 0) throw InputError("the nodes to solve have no triangle");
  mesh.positions.resize(vertex_count_, 3);
  result_.source.normals.resize(vertex_count_, 3);
  Eigen::Index row = 0;
  for (const Block& block : blocks_) {
    mesh.positions.middleRows(row, block.positions.rows()) = block.positions;
    result_.source.normals.middleRows(row, block.normals.rows()) = block.normals;
    row += block.positions.rows();
  }
  join_attributes();
  close_gaps();
  mesh.materials = scene_.materials;
  for (const GltfAnimation& animation : scene_.animations)
    result_.source.animations.push_back(animation.name);
  for (Group& group : mesh.groups) {
    std::sort(group.faces.begin(), group.faces.end());
    group.faces.erase(std::unique(group.faces.begin(), group.faces.end()), group.faces.end());
  }
  return std::move(result_);
}

}  // namespace

GltfFile build_mesh(const GltfScene& scene, const NodeTree& tree, const std::vector<int>& nodes,
                    std::span<const unsigned char> bytes) {
  Builder builder(scene, bytes);
  for (const int node : nodes) builder.add(node, tree);
  return builder.finish();
}

}  // namespace flexkey
