#pragma once

#include <vector>

#include "flexkey/animate/handle_states.h"
#include "flexkey/animate/scene.h"

namespace flexkey {

/// The handles of a scene that hold at one time, by number, increasing.
using ActiveSet = std::vector<int>;

ActiveSet active_at(const Scene& scene, double time);

/// Those of them that hold fully, and are not fading in or out.
ActiveSet firm_at(const Scene& scene, double time);

/// The scene's constraints with these handles alone.
Constraints constraints_of(const Scene& scene, const ActiveSet& active);

/// Where the vertices of constraints_of(scene, active).handles go, #vertices x 3.
Positions targets_of(const Scene& scene, const ActiveSet& active, const HandleStates& states);

}  // namespace flexkey
