#include "flexkey/animate/legs.h"

#include "flexkey/animate/lambda_field.h"

namespace flexkey {

Leg leg_of(const Take& take, const ActiveSet& active, int frame) {
  const double time = frame / take.shot.fps;
  return {take.scene, active, sample_states(take.scene, time), lambda_at(take.shot, take.scene, time),
          take.shot.solver.max_step};
}

}  // namespace flexkey
