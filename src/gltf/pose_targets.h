#pragma once

#include <cstddef>

#include "flexkey/animate/clip.h"
#include "flexkey/gltf/basis.h"
#include "flexkey/gltf/measure.h"
#include "flexkey/gltf/shape.h"
#include "flexkey/gltf/targets.h"
#include "flexkey/gltf/write_glb.h"

namespace flexkey {

/// What differs from rest by less is written as no difference, so that what a pose leaves alone takes no
/// space and can be split off.
struct StillBounds {
  double length = 0;  // of positions, file units
  double angle = 0;   // of normals, radians
};

/// The poses as morph targets, deltas from the clip's rest mesh. normals: empty where the file has none.
MorphTargets pose_targets(const Clip& clip, const std::vector<PoseShape>& poses, const NormalsAt& normals,
                          const StillBounds& still);

/// Gives the basis the poses' names, and weights of 0 at every key. Names that it has get a number.
void append_poses(Basis& basis, const std::vector<PoseShape>& poses);

/// The farthest that a vertex of a pose is shown from where it was solved, as a share of the rest diagonal:
/// read back at a weight of 1. The poses are the last targets of the basis.
double measure_poses(const Played& played, const Clip& clip, const std::vector<PoseShape>& poses,
                     const Basis& basis);

}  // namespace flexkey
