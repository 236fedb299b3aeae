#pragma once

#include <vector>

#include "flexkey/mesh/connectivity.h"
#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// The vertex nearest to a point; the lowest of several. The mesh has at least one vertex.
int nearest_vertex(const Positions& positions, const Vec3& point);

/// The vertices along the shortest chain of edges from one vertex to another, both included; empty where
/// there is none.
std::vector<int> shortest_path(const Mesh& mesh, const Neighbours& neighbours, int from, int to);

/// Distance of every vertex from `sources` along the surface, #V, infinity where no face leads; distances
/// past `limit` may be infinity too. Fast marching over the polygons' triangles (Kimmel and Sethian,
/// "Computing geodesic paths on manifolds", 1998): first order, never under an edge path's lower bound by
/// folding.
std::vector<double> geodesic_distances(const Mesh& mesh, const std::vector<int>& sources, double limit);

}  // namespace flexkey
