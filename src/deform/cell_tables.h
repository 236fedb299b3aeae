#pragma once

#include <vector>

#include "flexkey/deform/patch.h"

namespace flexkey {

/// What R_i and S_i are measured by: of each fitted cell, then zeros up to a multiple of eight.
struct RestMoments {
  std::vector<double> trace;                   // Σ ω |e|²
  std::vector<double> size;                    // Σ |ω| |e|²
  std::vector<double> xx, yy, zz, xy, yz, zx;  // Σ ω e eᵀ, which is symmetric
};

/// The fitted cells of a patch as the frame loop reads them: flat arrays in its order, and what of the rest
/// shape never changes.
struct CellTables {
  int free = 0, rows = 0, fitted = 0;  // as in Patch
  std::vector<int> offsets;            // #fitted + 1
  std::vector<int> neighbours;         // j of each directed edge, in patch numbering
  std::vector<double> weights;         // ω_ij of each
  Positions edges;                     // #edges x 3, ω_ij e_ij
  RestMoments moments;
};

CellTables tabulate(const Patch& patch);

}  // namespace flexkey
