#pragma once

#include <functional>
#include <string>
#include <vector>

#include "flexkey/animate/clip.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// A pose of the shot as the surface takes it.
struct SolvedPose {
  std::string name;
  Positions positions;  // #V x 3, vertices in the file's order, file units
  FrameReport report;   // of the way there: all its solves; frame is 0
};

/// The shot with its handles where a pose has them and nowhere else to go: their keyed motions, waves, noise
/// and fades are gone, parents and mirrors stay, and λ has its value of the shot's beginning. Handles that
/// only hold for a time hold where the pose leads them, and else let go.
Shot posed(const Shot& shot, const PoseOutput& pose);

/// Solves the shot's poses for the GLB, each from rest until it is converged, or as far as several times the
/// solver's `iterations` take it. stop: true ends the solve early, with the poses that are there then.
/// Throws as bind_shot and animate do.
std::vector<SolvedPose> solve_poses(const Shot& shot, const Mesh& mesh, const std::function<bool()>& stop);

}  // namespace flexkey
