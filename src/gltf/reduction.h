#pragma once

#include <vector>

#include "flexkey/animate/clip.h"
#include "flexkey/gltf/basis.h"
#include "flexkey/gltf/quantize.h"
#include "flexkey/gltf/shape.h"
#include "flexkey/gltf/steps.h"
#include "flexkey/gltf/targets.h"
#include "flexkey/gltf/write_glb.h"

namespace flexkey {

/// A clip as few targets.
struct Reduction {
  Basis basis;  // its targets are taken out
  MorphTargets
      targets;  // at least one, since glTF animates no weights of a mesh without; the poses come last
  std::size_t poses = 0;  // how many of them are the options' poses
  double rounding = 0;    // what integers may add to a vertex's distance on average, file units
};

/// How a clip is reduced.
struct ReductionPlan {
  NormalsAt normals;      // empty: the file has none
  double strictness = 1;  // in (0, 1]: the share of the tolerance to spend where targets become integers
};

/// Throws InputError for more targets than are allowed. Takes a step a frame with normals.
Reduction reduce(const Clip& clip, const ReductionPlan& plan, const GltfOptions& options, Steps& steps);

/// The targets in integers; their scales become part of the basis's weights. Poses stay floats, since whoever
/// poses by hand knows of no scale. length: as Reduction::rounding, in the targets' units.
QuantizedTargets quantize_targets(Reduction& reduction, double length);

}  // namespace flexkey
