#include "flexkey/animate/solve_inputs.h"

#include <vector>

#include "flexkey/animate/legs.h"
#include "flexkey/animate/members.h"
#include "flexkey/timeline/sampling.h"

namespace flexkey {

SolveInputs inputs_of(const Take& take, std::string_view program) {
  const Scene& scene = take.scene;
  const Mesh& surface = scene.weld.surface;
  std::vector<Vec3> pivots;
  bool changes = false;  // the order of elimination is another where handles take hold and let go
  for (const SceneHandle& bound : scene.handles) {
    pivots.push_back(bound.pivot);
    changes = changes || !bound.handle.active.empty();
  }
  return {digest_of(std::string(program)),
          digest_of(surface.positions, surface.face_offsets, surface.corners, scene.weld.to_surface),
          digest_of(scene.constraints, pivots, changes, scene.riders), digest_of(take.shot.solver)};
}

Digest motion_of(const Take& take, int frame, const Digest& before) {
  const double time = frame / take.shot.fps;
  const Leg leg = leg_of(take, active_at(take.scene, time), frame);
  const auto& [scene, active, now, lambda, max_step] =
      leg;  // the scene and the most step are among the inputs
  std::vector<double> grips;
  for (const SceneHandle& bound : scene.handles) grips.push_back(sample_grip(bound.handle, time));
  return digest_of(before, active, grips, now, lambda);
}

std::string difference(const SolveInputs& before, const SolveInputs& now) {
  if (before.program != now.program) return "another build of flexkey solved it";
  if (before.surface != now.surface) return "the mesh has changed";
  if (before.handles != now.handles) return "what the handles and regions hold has changed";
  if (before.solver != now.solver) return "the solver's settings have changed";
  return {};
}

}  // namespace flexkey
