#include "flexkey/gltf/split_source.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

#include "flexkey/gltf/gltf_scene.h"
#include "flexkey/gltf/primitive_faces.h"
#include "flexkey/gltf/read_accessor.h"

namespace flexkey {
namespace {

using Fate = PrimitiveSplit::Fate;

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

std::vector<int> shifted(std::vector<int> rows, int by) {
  for (int& row : rows) row += by;
  return rows;
}

std::vector<int> all_rows(const SolvedPrimitive& primitive) {
  std::vector<int> rows(index(primitive.vertex_count));
  std::iota(rows.begin(), rows.end(), primitive.first_vertex);
  return rows;
}

class Splitting {
 public:
  Splitting(const GltfSource& source, const std::vector<bool>& moved)
      : source_(source),
        moved_(moved),
        scene_(parse_gltf_scene(source.document.json)),
        reader_(scene_, source.document.bytes) {}

  void split(std::size_t n, SourceSplit& result) const;

 private:
  std::string why_impossible(const SolvedNode& node) const;
  bool can_part(const GltfPrimitive& primitive) const;
  std::vector<std::uint32_t> corners_of(const GltfPrimitive& primitive, int vertices) const;
  PrimitiveSplit split(const GltfPrimitive& primitive, const std::vector<bool>& moved) const;

  const GltfSource& source_;
  const std::vector<bool>& moved_;
  GltfScene scene_;
  AccessorReader reader_;
};

/// Empty where nothing speaks against it.
std::string Splitting::why_impossible(const SolvedNode& node) const {
  constexpr const char* instances = "EXT_mesh_gpu_instancing";
  const std::vector<std::string>& extensions = scene_.nodes[index(node.node)].extensions;
  if (!scene_.meshes[index(node.mesh)].primitives[0].targets.empty()) return "it has targets of its own";
  if (std::find(extensions.begin(), extensions.end(), instances) != extensions.end())
    return "its node shows it many times";
  return "";
}

/// Other extensions may name the primitive's vertices or faces.
bool Splitting::can_part(const GltfPrimitive& primitive) const {
  constexpr const char* variants = "KHR_materials_variants";
  constexpr int triangles = 4;
  const auto is_matrix = [&](const auto& attribute) {
    return scene_.accessors[index(attribute.second)].columns == 0;
  };
  const std::vector<std::string>& names = primitive.extensions;
  return primitive.mode >= triangles &&
         std::all_of(names.begin(), names.end(), [&](const auto& name) { return name == variants; }) &&
         std::none_of(primitive.attributes.begin(), primitive.attributes.end(), is_matrix);
}

/// The primitive's triangles as a list.
std::vector<std::uint32_t> Splitting::corners_of(const GltfPrimitive& primitive, int vertices) const {
  std::vector<int> named(index(vertices));
  std::iota(named.begin(), named.end(), 0);
  if (primitive.indices >= 0) named = reader_.indices(primitive.indices, named.size());
  std::vector<std::uint32_t> corners;
  for (const std::array<int, 3>& triangle : triangles_of_mode(named, primitive.mode))
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  return corners;
}

/// moved: by row of the primitive.
PrimitiveSplit Splitting::split(const GltfPrimitive& primitive, const std::vector<bool>& moved) const {
  PrimitiveSplit split;
  if (std::find(moved.begin(), moved.end(), true) == moved.end()) split.fate = Fate::stays;
  if (split.fate == Fate::stays || !can_part(primitive)) return split;
  split.faces = split_faces(corners_of(primitive, static_cast<int>(moved.size())), moved);
  if (split.faces.moving.triangles.empty()) split.fate = Fate::stays;
  const std::size_t named = split.faces.moving.vertices.size();
  if (named > 0 && named < moved.size()) split.fate = Fate::parts;
  return split;
}

void Splitting::split(std::size_t n, SourceSplit& result) const {
  const SolvedNode& node = source_.nodes[n];
  SplitNote& note = result.notes[n];
  std::vector<PrimitiveSplit> primitives;
  int targeted = 0;
  for (std::size_t p = 0; p < node.primitives.size(); ++p) {
    const SolvedPrimitive& solved = node.primitives[p];
    const auto first = moved_.begin() + solved.first_vertex;
    const std::vector<bool> moved(first, first + solved.vertex_count);
    PrimitiveSplit split = this->split(scene_.meshes[index(node.mesh)].primitives[p], moved);
    note.moved += static_cast<int>(std::count(moved.begin(), moved.end(), true));
    if (split.fate == Fate::moves) targeted += solved.vertex_count;
    if (split.fate == Fate::parts) targeted += static_cast<int>(split.faces.moving.vertices.size());
    primitives.push_back(std::move(split));
  }
  note.targeted = targeted;
  const std::string why = why_impossible(node);
  note = why.empty() ? decide_split(note) : left_whole(note, why);
  if (note.why_whole.empty()) result.nodes[n] = std::move(primitives);
}

}  // namespace

SourceSplit whole(const GltfSource& source) {
  SourceSplit split;
  for (const SolvedNode& node : source.nodes) {
    SplitNote note;
    note.mesh = node.name;
    for (const SolvedPrimitive& primitive : node.primitives) note.vertices += primitive.vertex_count;
    note.targeted = note.vertices;
    split.notes.push_back(std::move(note));
    split.nodes.emplace_back(node.primitives.size());
  }
  return split;
}

SourceSplit split_source(const GltfSource& source, const std::vector<bool>& moved) {
  SourceSplit result = whole(source);
  const Splitting splitting(source, moved);
  for (std::size_t n = 0; n < source.nodes.size(); ++n) splitting.split(n, result);
  if (std::any_of(result.nodes.begin(), result.nodes.end(), moves)) return result;
  // An animation needs a mesh with targets to play.
  SourceSplit still = whole(source);
  for (SplitNote& note : still.notes) note = left_whole(note, "nothing moves");
  return still;
}

std::vector<int> moving_rows(const SolvedPrimitive& primitive, const PrimitiveSplit& split) {
  if (split.fate == Fate::parts) return shifted(split.faces.moving.vertices, primitive.first_vertex);
  return split.fate == Fate::moves ? all_rows(primitive) : std::vector<int>();
}

std::vector<int> still_rows(const SolvedPrimitive& primitive, const PrimitiveSplit& split) {
  if (split.fate == Fate::parts) return shifted(split.faces.still.vertices, primitive.first_vertex);
  return split.fate == Fate::stays ? all_rows(primitive) : std::vector<int>();
}

bool moves(const std::vector<PrimitiveSplit>& primitives) {
  return std::any_of(primitives.begin(), primitives.end(),
                     [](const PrimitiveSplit& one) { return one.fate != Fate::stays; });
}

}  // namespace flexkey
