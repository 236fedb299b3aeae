#pragma once

#include "flexkey/animate/clip.h"
#include "flexkey/gltf/built.h"
#include "flexkey/gltf/steps.h"
#include "flexkey/gltf/write_glb.h"

namespace flexkey {

/// The file of `options.source` with the clip in it. strictness: see ReductionPlan.
/// Throws InputError for more targets than are allowed, and for a `merge_into` that no animation is called.
Built build_into_source(const Clip& clip, const GltfOptions& options, double strictness, Steps& steps);

}  // namespace flexkey
