#include "flexkey/timeline/read_motion_file.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "flexkey/mesh/error.h"
#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/motion_table.h"

namespace flexkey {
namespace {

/// A file's times are floats: one that is within their rounding of a frame is meant to be that frame's.
template <class Value>
void snap(Track<Value>& track, double fps) {
  constexpr double rounding = 1e-3;  // frames
  for (Key<Value>& key : track) {
    const double frame = std::round(key.time * fps);
    if (std::abs(key.time * fps - frame) <= rounding) key.time = frame / fps;
  }
}

MotionTracks tracks_of_node(const std::string& text, Scope& scope) {
  const std::size_t hash = text.rfind('#');
  if (hash == std::string::npos || hash + 1 == text.size())
    throw InputError(fmt::format("'{}' names no node; write it behind a #, as in rig.glb#Ear_L", text));
  MotionTracks tracks = scope.sources.node_motion(text.substr(0, hash), text.substr(hash + 1));
  snap(tracks.move, scope.fps);
  snap(tracks.rotate, scope.fps);
  snap(tracks.scale, scope.fps);
  return tracks;
}

MotionTracks tracks_of_table(const std::string& path, Scope& scope) {
  const std::string text = scope.sources.text(path);
  try {
    return motion_of_table(text);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace

MotionTracks read_motion_file(const Node& node, std::string_view place, Scope& scope) {
  const std::optional<Fields> fields = read_fields(node, motion_keys, place, scope.findings);
  if (!fields) return {};
  const std::vector<const Entry*>& sources = fields->entries();
  if (sources.size() != 1) {
    if (fields->lacks("from") == fields->lacks("csv"))
      scope.findings.error(node.where,
                           fmt::format("{} comes 'from' a node of a file or from a 'csv'", place));
    return {};
  }
  const Node& path = sources[0]->value;
  if (path.kind != Node::Kind::scalar) {
    scope.findings.error(path.where, fmt::format("{} is a path, not {}", place, describe(path)));
    return {};
  }
  try {
    return sources[0]->key.text == "from" ? tracks_of_node(path.text, scope)
                                          : tracks_of_table(path.text, scope);
  } catch (const Error& error) {
    scope.findings.error(path.where, error.what());
    return {};
  }
}

}  // namespace flexkey
