#pragma once

#include <vector>

#include "flexkey/deform/patch.h"

namespace flexkey {

/// Σ ω e eᵀ of a cell at rest, which is symmetric, and Σ |ω| |e|².
struct RestMoments {
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;
  double size = 0;

  double trace() const { return xx + yy + zz; }
};

/// The fitted cells of a patch as the frame loop reads them: flat arrays in its order, and what of the rest
/// shape never changes.
struct CellTables {
  int free = 0, rows = 0;            // as in Patch
  std::vector<int> offsets;          // #fitted + 1
  std::vector<int> neighbours;       // j of each directed edge, in patch numbering
  std::vector<double> weights;       // ω_ij of each
  Positions edges;                   // #edges x 3, ω_ij e_ij
  std::vector<RestMoments> moments;  // #fitted

  int fitted() const { return static_cast<int>(moments.size()); }
};

CellTables tabulate(const Patch& patch);

}  // namespace flexkey
