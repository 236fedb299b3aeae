#include "flexkey/animate/active_set.h"

#include "flexkey/timeline/sampling.h"

namespace flexkey {

ActiveSet active_at(const Scene& scene, double time) {
  ActiveSet active;
  for (std::size_t h = 0; h < scene.handles.size(); ++h)
    if (is_active(scene.handles[h].handle, time)) active.push_back(static_cast<int>(h));
  return active;
}

ActiveSet firm_at(const Scene& scene, double time) {
  ActiveSet firm;
  for (std::size_t h = 0; h < scene.handles.size(); ++h)
    if (sample_grip(scene.handles[h].handle, time) == 1) firm.push_back(static_cast<int>(h));
  return firm;
}

Constraints constraints_of(const Scene& scene, const ActiveSet& active) {
  Constraints constraints;
  constraints.region = scene.constraints.region;
  constraints.rigid = scene.constraints.rigid;
  for (std::size_t k = 0; k < active.size(); ++k) {
    const SceneHandle& bound = scene.handles[static_cast<std::size_t>(active[k])];
    constraints.strengths.push_back(bound.handle.weight);
    constraints.handles.insert(constraints.handles.end(), bound.vertices.begin(), bound.vertices.end());
    constraints.owner.resize(constraints.handles.size(), static_cast<int>(k));
  }
  return constraints;
}

Positions targets_of(const Scene& scene, const ActiveSet& active, const HandleStates& states) {
  Eigen::Index count = 0;
  for (const int h : active) count += scene.handles[static_cast<std::size_t>(h)].rest.rows();
  Positions positions(count, 3);
  Eigen::Index row = 0;
  for (const int h : active) {
    const Positions where = targets_of(scene, states, h);
    positions.middleRows(row, where.rows()) = where;
    row += where.rows();
  }
  return positions;
}

}  // namespace flexkey
