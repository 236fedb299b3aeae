#include "flexkey/animate/handle_matrices.h"

#include "flexkey/animate/handle_states.h"

namespace flexkey {

std::vector<Eigen::Matrix4d> handle_matrices(const Scene& scene, double time) {
  const HandleStates states = sample_states(scene, time);
  std::vector<Eigen::Matrix4d> matrices;
  for (int h = 0; h < static_cast<int>(scene.handles.size()); ++h)
    matrices.push_back(whole_motion(scene, states, h).matrix());
  return matrices;
}

}  // namespace flexkey
