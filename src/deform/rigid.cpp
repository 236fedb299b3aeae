#include "flexkey/deform/rigid.h"

#include <algorithm>
#include <map>
#include <utility>

#include "flexkey/deform/rotation.h"

namespace flexkey {
namespace {

/// Σ ω e′ eᵀ over the cells of a region: each edge inside twice, each edge that leaves it once.
Eigen::Matrix3d covariance_of_cells(const RigidRegion& region, const CellTables& cells,
                                    const Positions& positions) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const int i : region.vertices) {
    for (int k = cells.offsets[i]; k < cells.offsets[i + 1]; ++k) {
      const Eigen::RowVector3d e = positions.row(i) - positions.row(cells.neighbours[k]);
      sum += e.transpose() * cells.edges.row(k);
    }
  }
  return sum;
}

Eigen::Matrix3d covariance_of_vertices(const RigidRegion& region, const Positions& positions) {
  const Positions where = positions(region.vertices, Eigen::all);
  return (where.rowwise() - where.colwise().mean()).transpose() * region.arms;
}

}  // namespace

std::vector<RigidRegion> rigid_regions(const std::vector<int>& body, const Patch& patch) {
  std::map<int, RigidRegion> regions;
  for (int i = 0; i < patch.free; ++i) {
    const int number = body[patch.vertices[i]];
    if (number >= 0) regions[number].vertices.push_back(i);
  }
  std::vector<RigidRegion> result;
  for (auto& [number, region] : regions) {
    const Positions rest = patch.rest(region.vertices, Eigen::all);
    region.arms = rest.rowwise() - rest.colwise().mean();
    result.push_back(std::move(region));
  }
  return result;
}

Eigen::SparseMatrix<double> summing_matrix(const std::vector<RigidRegion>& regions, int free) {
  std::vector<int> body(static_cast<std::size_t>(free), -1);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    for (const int v : regions[r].vertices) body[v] = static_cast<int>(r);
  }
  int unknowns = 0;
  std::vector<Eigen::Triplet<double>> entries;
  for (int v = 0; v < free; ++v) {
    if (body[v] < 0) entries.emplace_back(v, unknowns++, 1.0);
  }
  for (int v = 0; v < free; ++v) {
    if (body[v] >= 0) entries.emplace_back(v, unknowns + body[v], 1.0);
  }
  Eigen::SparseMatrix<double> C(free, unknowns + static_cast<int>(regions.size()));
  C.setFromTriplets(entries.begin(), entries.end());
  return C;
}

std::vector<int> places_of_unknowns(const Eigen::SparseMatrix<double>& C, const std::vector<int>& places) {
  std::vector<int> last;
  for (int k = 0; k < C.outerSize() && !places.empty(); ++k) {
    last.push_back(0);
    for (Eigen::SparseMatrix<double>::InnerIterator entry(C, k); entry; ++entry)
      last.back() = std::max(last.back(), places[entry.row()]);
  }
  return last;
}

const Eigen::Matrix3d& rotation_of(const RigidRegion& region, const Transforms& transforms) {
  return transforms.rotations[region.vertices.front()];
}

void turn_as_one(const std::vector<RigidRegion>& regions, const CellTables& cells, const Positions& positions,
                 const std::vector<Eigen::Matrix3d>& last, Transforms& transforms) {
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const RigidRegion& region = regions[r];
    const Eigen::Matrix3d of_cells = best_rotation(covariance_of_cells(region, cells, positions), last[r]);
    const Eigen::Matrix3d Q = best_rotation(covariance_of_vertices(region, positions), of_cells);
    for (const int i : region.vertices) {
      transforms.rotations[i] = Q;
      transforms.scales.row(i).setOnes();
    }
  }
}

Positions place(const std::vector<RigidRegion>& regions, const Transforms& transforms, Positions& positions) {
  Eigen::Index count = 0;
  for (const RigidRegion& region : regions) count += region.arms.rows();
  Positions were(count, 3);
  Eigen::Index first = 0;
  for (const RigidRegion& region : regions) {
    const Eigen::Index size = region.arms.rows();
    were.middleRows(first, size) = positions(region.vertices, Eigen::all);
    const Eigen::RowVector3d middle = were.middleRows(first, size).colwise().mean();
    const Positions turned = region.arms * rotation_of(region, transforms).transpose();
    positions(region.vertices, Eigen::all) = turned.rowwise() + middle;
    first += size;
  }
  return were;
}

void take_back(const std::vector<RigidRegion>& regions, const Positions& were, Positions& positions,
               Positions& step) {
  Eigen::Index row = 0;
  for (const RigidRegion& region : regions) {
    for (const int v : region.vertices) {
      step.row(v) += positions.row(v) - were.row(row);
      positions.row(v) = were.row(row++);
    }
  }
}

}  // namespace flexkey
