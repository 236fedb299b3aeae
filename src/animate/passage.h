#pragma once

#include <memory>
#include <vector>

#include "flexkey/animate/active_set.h"
#include "flexkey/animate/deformer_cache.h"

namespace flexkey {

/// A surface on its way through a shot.
struct Passage {
  ActiveSet active;  // what held it in the last frame
  std::shared_ptr<const Deformer> deformer;
  Pose pose;
  HandleStates before;  // of the last frame
};

/// At rest before the first frame.
Passage start_of(const Scene& scene, DeformerCache& cache);

/// What takes a passage to its next frame.
struct Leg {
  const Scene& scene;
  ActiveSet active;
  HandleStates now;
  Eigen::VectorXd lambda;  // #V of the surface
  double max_step = 0;     // the most that a handle turns in one solve, radians
};

/// Takes each passage one frame further, in as many equal parts as keep each turn within max_step; those that
/// the same handles hold are solved together. Where handles take hold or let go, the surface goes on from the
/// shape that it has. passages, legs: equally many.
std::vector<SolveReport> advance(const std::vector<Passage*>& passages, const std::vector<Leg>& legs,
                                 DeformerCache& cache);

}  // namespace flexkey
