#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "flexkey/deform/cell_tables.h"
#include "flexkey/deform/local_step.h"
#include "flexkey/deform/patch.h"

namespace flexkey {

/// Vertices of F that move as one body, p′_i = t + Q a_i. All of its cells have R = T = Q.
struct RigidRegion {
  std::vector<int> vertices;  // of F
  Positions arms;             // #vertices x 3, a_i: rest less its mean
};

/// body: #V, the number of the region that a mesh vertex is in, or -1. Vertices outside F, such as those of
/// no triangle, are left out.
std::vector<RigidRegion> rigid_regions(const std::vector<int>& body, const Patch& patch);

/// C: what all vertices of F are moved by when the vertices outside the regions, in order, and then the
/// regions as a whole are; free x #unknowns, 0 or 1.
Eigen::SparseMatrix<double> summing_matrix(const std::vector<RigidRegion>& regions, int free);

/// The place of each unknown, a column of C, in an order of elimination from those of the vertices of F. A
/// region comes last of all that it touches, since its row is long. places: empty gives none.
std::vector<int> places_of_unknowns(const Eigen::SparseMatrix<double>& C, const std::vector<int>& places);

/// The rotation that the last local step or prediction gave to a region.
const Eigen::Matrix3d& rotation_of(const RigidRegion& region, const Transforms& transforms);

/// The local step's last part: one Q for each region, the best for its vertices at these positions. What they
/// leave open, as the turn of a row of vertices about itself, is as near as can be to the best for the cells
/// of the region with the edges that leave it. last: Q of each region before.
void turn_as_one(const std::vector<RigidRegion>& regions, const CellTables& cells, const Positions& positions,
                 const std::vector<Eigen::Matrix3d>& last, Transforms& transforms);

/// Puts each region where its Q has it, about the mean of where its vertices are. Returns where they were, a
/// row each, region by region.
Positions place(const std::vector<RigidRegion>& regions, const Transforms& transforms, Positions& positions);

/// Puts the vertices back to where they were and makes a step from the placed positions one from there.
void take_back(const std::vector<RigidRegion>& regions, const Positions& were, Positions& positions,
               Positions& step);

}  // namespace flexkey
