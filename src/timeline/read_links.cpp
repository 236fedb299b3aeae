#include "flexkey/timeline/read_links.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "flexkey/timeline/play_out.h"

namespace flexkey {
namespace {

constexpr int nobody = -1;

/// The number of the handle that a node names.
int handle_of(const Node& node, const std::vector<Handle>& handles, Scope& scope) {
  std::vector<std::string> names;
  for (std::size_t h = 0; h < handles.size(); ++h) {
    if (node.kind == Node::Kind::scalar && handles[h].name == node.text) return static_cast<int>(h);
    names.push_back(handles[h].name);
  }
  const std::string found = node.kind == Node::Kind::scalar
                                ? fmt::format("unknown handle '{}'", node.text)
                                : fmt::format("a handle's name belongs here, not {}", describe(node));
  scope.findings.error(node.where, found + scope.findings.proposal(node.text, names));
  return nobody;
}

/// Whether the way from a handle by `next` leads back to it.
template <class Next>
bool comes_back(std::size_t start, const std::vector<Handle>& handles, const Next& next) {
  int at = next(handles[start]);
  for (std::size_t steps = 0; at != nobody && steps < handles.size(); ++steps) {
    if (at == static_cast<int>(start)) return true;
    at = next(handles[static_cast<std::size_t>(at)]);
  }
  return false;
}

int parent_of(const Handle& handle) {
  return handle.parent;
}

int mirrored_by(const Handle& handle) {
  return handle.mirror ? handle.mirror->of : nobody;
}

void refuse_circle(const Node& node, std::string_view what, const Handle& handle, Scope& scope) {
  scope.findings.error(node.where, fmt::format("the {} of handle '{}' comes back to '{}' itself", what,
                                               handle.name, handle.name));
}

}  // namespace

void link_handles(const std::vector<HandleLinks>& links, std::vector<Handle>& handles, Scope& scope) {
  for (std::size_t h = 0; h < handles.size(); ++h) {
    if (const Node* parent = links[h].parent) handles[h].parent = handle_of(*parent, handles, scope);
    const Node* source = links[h].mirror_of;
    if (source == nullptr || !handles[h].mirror) continue;
    const int of = handles[h].mirror->of = handle_of(*source, handles, scope);
    if (of == nobody) continue;
    const Handle& mirrored = handles[static_cast<std::size_t>(of)];
    scope.last_key = std::max(scope.last_key, keyed_time(mirrored).to + handles[h].mirror->delay);
    if (!mirrored.curve.empty())
      scope.findings.error(
          source->where,
          fmt::format("handle '{}' is led by 'curve', which cannot be mirrored", source->text));
  }
  for (std::size_t h = 0; h < handles.size(); ++h) {
    if (comes_back(h, handles, parent_of)) refuse_circle(*links[h].parent, "parent", handles[h], scope);
    if (comes_back(h, handles, mirrored_by)) refuse_circle(*links[h].mirror_of, "mirror", handles[h], scope);
  }
}

}  // namespace flexkey
