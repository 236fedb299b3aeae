#include "flexkey/animate/solve_inputs.h"

#include <vector>

#include "flexkey/animate/laps.h"
#include "flexkey/animate/legs.h"
#include "flexkey/animate/members.h"
#include "flexkey/timeline/sampling.h"
#include "flexkey/timeline/steps.h"

namespace flexkey {

SolveInputs inputs_of(const Take& take, std::string_view program) {
  const Scene& scene = take.scene;
  const Mesh& surface = scene.weld.surface;
  std::vector<Vec3> pivots;
  std::vector<int> parents, curves;
  int changing = 0;  // the order of elimination is another where handles take hold and let go
  for (const SceneHandle& bound : scene.handles) {
    pivots.push_back(bound.pivot);
    parents.push_back(bound.handle.parent);
    curves.push_back(bound.handle.curve.empty() ? 0 : 1);
    changing = bound.handle.active.empty() ? changing : 1;
  }
  return {digest_of(std::string(program)),
          digest_of(surface.positions, surface.face_offsets, surface.corners, scene.weld.to_surface),
          digest_of(scene.constraints, pivots, parents, curves, changing, scene.riders),
          digest_of(take.shot.solver)};
}

Digest motion_of(const Take& take, int step, const Digest& before) {
  const double time = time_of_step(take.shot, step);
  const Leg leg = leg_of(take, active_at(take.scene, time), step);
  const auto& [scene, active, now, lambda, max_step] = leg;  // of which the first and last are inputs
  std::vector<double> grips;
  for (const SceneHandle& bound : scene.handles) grips.push_back(sample_grip(bound.handle, time));
  return digest_of(before, active, grips, now, targets_of(scene, now), lambda, turns_to_unwind(take, step));
}

std::string difference(const SolveInputs& before, const SolveInputs& now) {
  if (before.program != now.program) return "another build of flexkey solved it";
  if (before.surface != now.surface) return "the mesh has changed";
  if (before.handles != now.handles) return "what the handles and regions hold has changed";
  if (before.solver != now.solver) return "the solver's settings have changed";
  return {};
}

}  // namespace flexkey
