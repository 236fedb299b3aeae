#include "flexkey/animate/legs.h"

#include "flexkey/animate/lambda_field.h"
#include "flexkey/timeline/steps.h"

namespace flexkey {

Leg leg_of(const Take& take, const ActiveSet& active, int step) {
  const double time = time_of_step(take.shot, step);
  return {take.scene, active, sample_states(take.scene, time), lambda_at(take.shot, take.scene, time),
          take.shot.solver.max_step};
}

}  // namespace flexkey
