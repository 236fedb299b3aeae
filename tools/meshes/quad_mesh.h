#pragma once

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace flexkey::meshes {

using Index = std::size_t;
using Vec3 = Eigen::Vector3d;
using Quad = std::array<Index, 4>;

// A mesh of quads, each one belonging to a named part. A name is GROUP or GROUP:MATERIAL, so that a
// hoof can be dark and still move with its leg.
//
// The mirror maps tell which vertex and which face lie across the plane x = 0; they are carried
// through subdivision so that symmetry holds exactly, not just within rounding.
struct QuadMesh {
  std::vector<Vec3> vertices;
  std::vector<Quad> faces;
  std::vector<Index> parts;
  std::vector<std::string> part_names;
  std::vector<Index> vertex_mirror;
  std::vector<Index> face_mirror;
};

// Index of the part of that name, added when it is new.
Index part_index(QuadMesh& mesh, const std::string& name);

Vec3 face_centre(const QuadMesh& mesh, Index face);

// Normal of a face scaled by its area.
Vec3 face_area_vector(const QuadMesh& mesh, Index face);

// Completes a half (x >= 0) whose border lies on x = 0; parts named "_left" get a "_right" twin.
QuadMesh mirrored(const QuadMesh& half);

// Makes positions exactly symmetric by averaging each vertex with its mirror image.
void symmetrise(QuadMesh& mesh);

}  // namespace flexkey::meshes
