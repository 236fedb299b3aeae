#pragma once

#include <cstdint>
#include <vector>

#include "flexkey/gltf/float_rows.h"
#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// The faces of one material as triangles: what becomes one glTF primitive with vertices of its own.
struct Primitive {
  int material = -1;           // index of Mesh::materials, or -1
  std::vector<int> vertices;   // #vertices, the file vertex of each
  std::vector<int> texcoords;  // #vertices, row of Mesh::texcoords or -1; empty where no corner has one
  std::vector<std::uint32_t> triangles;  // 3 a triangle, rows of `vertices`
  std::vector<int> faces;                // #triangles, the file face of each, increasing
};

/// Splits a mesh by material, in the materials' order and with the faces of none last. Materials without a
/// face are left out. Corners that share file vertex and texture coordinate share a vertex. Polygons are cut
/// at rest; triangles that name a vertex twice are dropped. Throws InputError if no triangle is left, or for
/// a polygon that `triangulate` cannot cut.
std::vector<Primitive> split_primitives(const Mesh& mesh);

/// The rows of the file's vertices that the primitive's vertices are made of, #vertices x 3.
FloatRows gather(const FloatRows& rows, const Primitive& primitive);

/// The primitive's texture coordinates as glTF has them, #vertices x 2: v grows downwards. Corners without
/// one get 0.
FloatRows texcoords_of(const Mesh& mesh, const Primitive& primitive);

}  // namespace flexkey
