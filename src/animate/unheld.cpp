#include "flexkey/animate/unheld.h"

#include <fmt/format.h>

#include <algorithm>

#include "flexkey/animate/active_set.h"
#include "flexkey/timeline/number.h"
#include "flexkey/timeline/steps.h"

namespace flexkey {
namespace {

/// What may hold a component.
struct Support {
  bool is_solved = false;    // has vertices in the region
  bool is_anchored = false;  // and others that are held outside
  std::vector<int> handles;  // that lead some of it, increasing
};

std::vector<Support> supports_of(const Scene& scene, const Components& components,
                                 const std::vector<bool>& in_region) {
  std::vector<Support> supports(static_cast<std::size_t>(components.count));
  for (std::size_t v = 0; v < in_region.size(); ++v) {
    if (components.of_vertex[v] < 0) continue;
    Support& support = supports[static_cast<std::size_t>(components.of_vertex[v])];
    (in_region[v] ? support.is_solved : support.is_anchored) = true;
  }
  for (std::size_t h = 0; h < scene.handles.size(); ++h)
    for (const int v : scene.handles[h].vertices) {
      const int component = components.of_vertex[static_cast<std::size_t>(v)];
      if (component < 0) continue;
      std::vector<int>& handles = supports[static_cast<std::size_t>(component)].handles;
      if (handles.empty() || handles.back() != static_cast<int>(h)) handles.push_back(static_cast<int>(h));
    }
  return supports;
}

/// The first of some handles that is in a set, or -1.
int first_in(const ActiveSet& set, const std::vector<int>& handles) {
  const auto found = std::find_first_of(handles.begin(), handles.end(), set.begin(), set.end());
  return found == handles.end() ? -1 : *found;
}

}  // namespace

std::vector<Diagnostic> find_unheld(const Shot& shot, const Scene& scene, const Components& components,
                                    const std::vector<bool>& in_region) {
  std::vector<Support> supports = supports_of(scene, components, in_region);
  std::vector<Diagnostic> errors;
  for (int step = 0; step < step_count(shot); ++step) {
    const double time = time_of_step(shot, step);
    const ActiveSet active = active_at(scene, time), firm = firm_at(scene, time);
    if (firm.size() == scene.handles.size()) continue;
    for (std::size_t c = 0; c < supports.size(); ++c) {
      const auto& [is_solved, is_anchored, handles] = supports[c];
      if (!is_solved || is_anchored || handles.empty() || first_in(firm, handles) >= 0) continue;
      const int fading = first_in(active, handles);
      const Handle& handle =
          scene.handles[static_cast<std::size_t>(fading < 0 ? handles.front() : fading)].handle;
      const char* cause = fading < 0 ? "no handle on it is active" : "all that is active on it fades";
      errors.push_back(
          {Diagnostic::Severity::error, handle.where,
           fmt::format("nothing holds the surface of '{}' at {}s: {}; hold it somewhere at every time",
                       handle.name, number_text(time), cause)});
      supports[c].is_solved = false;  // once is enough
    }
  }
  return errors;
}

}  // namespace flexkey
