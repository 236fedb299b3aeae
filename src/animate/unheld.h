#pragma once

#include <vector>

#include "flexkey/animate/scene.h"
#include "flexkey/mesh/connectivity.h"

namespace flexkey {

/// An error for each component that nothing holds in some frame of the shot, because its handles are not
/// active then or all of them fade, with the first such time. in_region: #V of the surface, whether the solve
/// may move a vertex; what it may not holds its component.
std::vector<Diagnostic> find_unheld(const Shot& shot, const Scene& scene, const Components& components,
                                    const std::vector<bool>& in_region);

}  // namespace flexkey
