#pragma once

#include "flexkey/gltf/basis.h"
#include "flexkey/gltf/motion.h"

namespace flexkey {

/// Principal components of the deltas from rest: the fewest targets, with weights of any sign and largest
/// magnitude 1. No vertex is played farther than `tolerance` (file units) from where it was solved, as
/// largest_error tells; 0 means float rounding. Leave room for what the targets' encoding adds.
Basis pca_basis(const Motion& motion, double tolerance);

}  // namespace flexkey
