#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace flexkey {

/// Points or vectors to draw, #rows x 3, single precision.
using Points = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// What is drawn of a mesh: triangles of the subdivided surface, the same for every frame.
struct Surface {
  int vertex_count = 0;
  std::vector<std::array<int, 3>> triangles;              // vertices, counter-clockwise seen from outside
  std::vector<int> face_of;                               // #triangles, face of the file that each is part of
  std::vector<std::array<Eigen::Vector2f, 3>> texcoords;  // #triangles, or empty where the file has none
  std::vector<std::array<int, 2>> wires;                  // edges that lie on edges of the file's polygons
  std::vector<int> of_vertex;                             // #V of the file, its place on the surface or -1
};

}  // namespace flexkey
