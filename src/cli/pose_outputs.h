#pragma once

#include <vector>

#include "cli/load.h"
#include "cli/report.h"
#include "cli/session.h"
#include "flexkey/gltf/write_glb.h"

namespace flexkey::cli {

/// Refuses, before hours of solving, poses that nothing would hold or whose handles share vertices. Throws
/// TimelineError.
void check_pose_outputs(const LoadedShot& loaded, const ShotOptions& options);

/// Solves the poses that a run's GLB gets, and adds them to the report; fewer where a signal came.
std::vector<PoseShape> solve_pose_shapes(const Session& session, const Shot& run, RunReport& report);

}  // namespace flexkey::cli
