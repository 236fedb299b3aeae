#pragma once

#include "flexkey/gltf/basis.h"
#include "flexkey/gltf/motion.h"

namespace flexkey {

/// Every frame a blend of two targets, or of one and rest: weights in 0..1, at most two of them active at any
/// time, and their sum at most 1. The targets lie where the motion bends; it comes back to a target when its
/// shape returns, and rest takes none. No vertex is played farther than `tolerance` (file units) from where
/// it was solved, as largest_error tells; 0 means float rounding.
Basis knot_basis(const Motion& motion, double tolerance);

}  // namespace flexkey
