#pragma once

#include "flexkey/deform/options.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// The timeline's solver settings in the deformer's terms.
DeformOptions deform_options(const SolverSettings& solver);

}  // namespace flexkey
