#include "flexkey/gltf/primitives.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <map>
#include <unordered_map>

#include "flexkey/gltf/triangulate.h"
#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

std::uint64_t joined(std::uint32_t high, std::uint32_t low) {
  return (std::uint64_t{high} << 32) | low;
}

/// The first row with the same texture coordinates, a row; many files repeat them at every corner.
std::vector<int> first_equal_rows(const TexCoords& texcoords) {
  std::unordered_map<std::uint64_t, int> first;
  std::vector<int> rows;
  for (int row = 0; row < texcoords.rows(); ++row) {
    const Eigen::RowVector2f uv = texcoords.row(row).cast<float>();
    const std::uint64_t key =
        joined(std::bit_cast<std::uint32_t>(uv.x()), std::bit_cast<std::uint32_t>(uv.y()));
    rows.push_back(first.try_emplace(key, row).first->second);
  }
  return rows;
}

/// The corners of face f without those that repeat the vertex before them.
std::vector<int> distinct_corners(const Mesh& mesh, int f) {
  std::vector<int> corners;
  const int first = mesh.face_offsets[static_cast<std::size_t>(f)];
  const int last = mesh.face_offsets[static_cast<std::size_t>(f) + 1];
  const auto vertex = [&](int corner) { return mesh.corners[static_cast<std::size_t>(corner)]; };
  for (int corner = first; corner < last; ++corner) {
    if (corners.empty() || vertex(corner) != vertex(corners.back())) corners.push_back(corner);
  }
  while (corners.size() > 1 && vertex(corners.back()) == vertex(corners.front())) corners.pop_back();
  return corners;
}

/// Triangles of face f as indices into Mesh::corners.
std::vector<std::array<int, 3>> triangles_of(const Mesh& mesh, int f) {
  const std::vector<int> corners = distinct_corners(mesh, f);
  if (corners.size() < 3) return {};
  Positions positions(static_cast<Eigen::Index>(corners.size()), 3);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const int vertex = mesh.corners[static_cast<std::size_t>(corners[i])];
    positions.row(static_cast<Eigen::Index>(i)) = mesh.positions.row(vertex);
  }
  std::vector<std::array<int, 3>> triangles = triangulate(positions);
  for (auto& triangle : triangles) {
    for (int& corner : triangle) corner = corners[static_cast<std::size_t>(corner)];
  }
  std::erase_if(triangles, [&](const std::array<int, 3>& t) {
    const auto vertex = [&](int i) {
      return mesh.corners[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])];
    };
    return vertex(0) == vertex(1) || vertex(1) == vertex(2) || vertex(2) == vertex(0);
  });
  return triangles;
}

/// Collects the triangles of one material and numbers their vertices as they come.
class PrimitiveBuilder {
 public:
  void add(const Mesh& mesh, int corner, int texcoord) {
    const int vertex = mesh.corners[static_cast<std::size_t>(corner)];
    const std::uint64_t key =
        joined(static_cast<std::uint32_t>(vertex), static_cast<std::uint32_t>(texcoord));
    const auto next = static_cast<std::uint32_t>(primitive.vertices.size());
    const auto [entry, is_new] = rows_.try_emplace(key, next);
    if (is_new) {
      primitive.vertices.push_back(vertex);
      primitive.texcoords.push_back(texcoord);
    }
    primitive.triangles.push_back(entry->second);
  }

  Primitive primitive;

 private:
  std::unordered_map<std::uint64_t, std::uint32_t> rows_;
};

}  // namespace

std::vector<Primitive> split_primitives(const Mesh& mesh) {
  const std::vector<int> texcoord_rows = first_equal_rows(mesh.texcoords);
  const auto texcoord_at = [&](int corner) {
    const int row =
        mesh.corner_texcoord.empty() ? -1 : mesh.corner_texcoord[static_cast<std::size_t>(corner)];
    return row < 0 ? -1 : texcoord_rows[static_cast<std::size_t>(row)];
  };
  std::map<int, PrimitiveBuilder> builders;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const int material = mesh.face_material.empty() ? -1 : mesh.face_material[static_cast<std::size_t>(f)];
    const int rank = material < 0 ? std::numeric_limits<int>::max() : material;
    for (const auto& triangle : triangles_of(mesh, f)) {
      PrimitiveBuilder& builder = builders[rank];
      builder.primitive.material = material;
      builder.primitive.faces.push_back(f);
      for (const int corner : triangle) builder.add(mesh, corner, texcoord_at(corner));
    }
  }
  if (builders.empty())
    throw InputError("the mesh has no face with three different vertices, so glTF cannot show it");

  std::vector<Primitive> primitives;
  for (auto& [rank, builder] : builders) {
    std::vector<int>& texcoords = builder.primitive.texcoords;
    if (std::all_of(texcoords.begin(), texcoords.end(), [](int row) { return row < 0; })) texcoords.clear();
    primitives.push_back(std::move(builder.primitive));
  }
  return primitives;
}

FloatRows gather(const FloatRows& rows, const Primitive& primitive) {
  return rows(primitive.vertices, Eigen::all);
}

FloatRows texcoords_of(const Mesh& mesh, const Primitive& primitive) {
  FloatRows rows = FloatRows::Zero(static_cast<Eigen::Index>(primitive.texcoords.size()), 2);
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    const int texcoord = primitive.texcoords[static_cast<std::size_t>(row)];
    if (texcoord < 0) continue;
    rows(row, 0) = static_cast<float>(mesh.texcoords(texcoord, 0));
    rows(row, 1) = static_cast<float>(1.0 - mesh.texcoords(texcoord, 1));
  }
  return rows;
}

}  // namespace flexkey
