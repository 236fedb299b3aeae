#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "flexkey/animate/scene.h"
#include "flexkey/timeline/sampling.h"

namespace flexkey {

/// Where all handles of a scene are at one time.
struct HandleStates {
  std::vector<HandleMotion>
      motions;                    // #handles, their own, parents left out; unused where vertices are given
  std::vector<Positions> curves;  // #handles, the vertices of a `curve` handle, or of one that is led
                                  // vertex by vertex, parents followed; else empty
};

/// All handles at rest, and as the timeline has them at a time (seconds).
HandleStates rest_states(const Scene& scene);
HandleStates sample_states(const Scene& scene, double time);

/// Between two states, by their parameters: angles, offsets and factors, so that half of two turns is one.
/// share: 0 is `from`, 1 is `to`.
HandleStates blend(const HandleStates& from, const HandleStates& to, double share);

/// Where the vertices of Scene::constraints.handles go, #vertices x 3.
Positions targets_of(const Scene& scene, const HandleStates& states);

/// Of one handle, #vertices x 3.
Positions targets_of(const Scene& scene, const HandleStates& states, int handle);

/// What a handle's motion and those of its parents make of space. Of a `curve` handle the rigid motion that
/// best takes its chain to the curve.
Eigen::Affine3d whole_motion(const Scene& scene, const HandleStates& states, int handle);

/// Each handle's world rotation vector from one state to the next, #handles x 3, radians: from the keyed
/// angles, its parents' included and whole turns counted; where vertices are given the rotation that best
/// maps them.
Positions turns_between(const Scene& scene, const HandleStates& from, const HandleStates& to);

}  // namespace flexkey
