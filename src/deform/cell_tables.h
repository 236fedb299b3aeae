#pragma once

#include <vector>

#include "flexkey/deform/patch.h"

namespace flexkey {

/// The squares of the edges that R_i and S_i are fitted to, the cell's own ω_ij e_ij or with its rims: of
/// each fitted cell, then zeros up to a multiple of eight.
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
  Positions edges;  // #edges x 3, a_ij: Σ ω e′ eᵀ of the fit is Σ_j (p′_i − p′_j) a_ijᵀ
  // The rigid part of eq 4 is own R_i δ_i + (1 − own) Σ_j R_j d_ij, with δ_i = Σ_j d_ij.
  Positions pulls;  // #edges x 3, d_ij; empty where they are the a_ij
  double own = 0.5;
  RestMoments moments;
};

/// The cells of spokes alone: a_ij = d_ij = ω_ij e_ij.
CellTables tabulate(const Patch& patch);

RestMoments no_moments(int fitted);

/// Adds an edge e of this weight to the moments of cell i.
void add_moments(const Vec3& e, double weight, RestMoments& sums, int i);

}  // namespace flexkey
