#pragma once

#include <vector>

#include "flexkey/deform/cell_tables.h"
#include "flexkey/deform/cotangents.h"
#include "flexkey/deform/patch.h"

namespace flexkey {

/// Makes the cells of spokes cells of spokes and rims: R_i and S_i are fitted to all edges of the triangles
/// around v_i, each with the weight that it has of its triangle. At λ = 1 the direct step then minimises
/// Σ_t Σ_{e ∈ t} ω_e^t Σ_{i ∈ t} |e′ − R_i e|², a discretisation that is consistent under refinement (Chao,
/// Pinkall, Sanan, Schröder, "A Simple Geometric Model for Elastic Deformations", 2010).
/// triangles: in mesh numbering, those of the patch's cells.
void add_rims(const std::vector<WeightedTriangle>& triangles, const Patch& patch, CellTables& tables);

}  // namespace flexkey
