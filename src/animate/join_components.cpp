#include "flexkey/animate/join_components.h"

#include <algorithm>
#include <numeric>

namespace flexkey {
namespace {

/// The lowest component that c is joined to.
int root(const std::vector<int>& joined_to, int c) {
  while (joined_to[static_cast<std::size_t>(c)] != c) c = joined_to[static_cast<std::size_t>(c)];
  return c;
}

}  // namespace

Components join_components(const Components& components, const std::vector<std::vector<int>>& groups) {
  std::vector<int> joined_to(static_cast<std::size_t>(components.count));
  std::iota(joined_to.begin(), joined_to.end(), 0);
  for (const std::vector<int>& group : groups) {
    int first = -1;
    for (const int v : group) {
      const int component = components.of_vertex[static_cast<std::size_t>(v)];
      if (component < 0) continue;
      const int here = root(joined_to, component), there = first < 0 ? here : root(joined_to, first);
      joined_to[static_cast<std::size_t>(std::max(here, there))] = std::min(here, there);
      first = component;
    }
  }
  Components result;
  std::vector<int> number(joined_to.size(), -1);
  for (int c = 0; c < components.count; ++c) {
    const int lowest = root(joined_to, c);
    if (lowest == c) number[static_cast<std::size_t>(c)] = result.count++;
    number[static_cast<std::size_t>(c)] = number[static_cast<std::size_t>(lowest)];
  }
  for (const int c : components.of_vertex)
    result.of_vertex.push_back(c < 0 ? c : number[static_cast<std::size_t>(c)]);
  return result;
}

}  // namespace flexkey
