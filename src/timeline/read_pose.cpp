#include "flexkey/timeline/read_pose.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "flexkey/timeline/cues.h"
#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/read_motion.h"
#include "flexkey/timeline/read_rotate.h"
#include "flexkey/timeline/read_track.h"
#include "flexkey/timeline/vector.h"

namespace flexkey {
namespace {

constexpr std::string_view rest = "rest";

std::optional<PosedHandle> read_posed(const Entry& entry, const std::string& place, Scope& scope) {
  const std::optional<Fields> fields = read_fields(entry.value, posed_keys, place, scope.findings);
  if (!fields) return std::nullopt;
  PosedHandle posed;
  posed.where = entry.key.where;
  if (const Node* node = fields->value("move")) posed.move = read_vector(*node, scope).value_or(posed.move);
  if (const Node* node = fields->value("rotate"))
    posed.rotation = read_turn(*node, fmt::format("'rotate' of {}", place), scope).value_or(posed.rotation);
  if (const Node* node = fields->value("scale"))
    posed.scale = read_factors(*node, scope).value_or(posed.scale);
  return posed;
}

std::optional<NamedPose> read_pose(const Entry& entry, Scope& scope) {
  if (!is_mapping(entry.value, fmt::format("pose '{}'", entry.key.text), "{corner_L: {move: [0, 1, 0]}}",
                  scope.findings))
    return std::nullopt;
  NamedPose pose;
  for (const Entry& handle : entry.value.entries) {
    const std::string place = fmt::format("handle '{}' in pose '{}'", handle.key.text, entry.key.text);
    if (const std::optional<PosedHandle> posed = read_posed(handle, place, scope))
      pose[handle.key.text] = *posed;
  }
  return pose;
}

/// A handle in the pose of this name; at rest where the pose does not lead it.
std::optional<PosedHandle> posed_by(const Node& name, std::string_view handle, Scope& scope) {
  if (name.kind == Node::Kind::scalar && name.text == rest) return PosedHandle{};
  const std::optional<NamedPose> pose = look_up(scope.poses, name, "pose", "poses", scope.findings);
  if (!pose) return std::nullopt;
  const auto found = pose->find(handle);
  return found == pose->end() ? PosedHandle{} : found->second;
}

std::vector<Cue> cues_in(const std::string& path, Scope& scope) {
  const std::string text = scope.sources.text(path);
  try {
    return cues_of(text, scope.fps);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", path, error.what()));
  }
}

/// The cues of a file as if they were keys; each Node lives in `nodes`.
std::vector<WrittenKey> read_cues(const Node& path, const Easing& ease, Scope& scope,
                                  std::vector<Node>& nodes) {
  std::vector<WrittenKey> keys;
  try {
    for (const Cue& cue : cues_in(path.text, scope)) {
      nodes.push_back({Node::Kind::scalar, cue.name, {}, {}, path.where});
      keys.push_back({cue.time, ease, nullptr, path.where});
    }
  } catch (const Error& error) {
    scope.findings.error(path.where, error.what());
  }
  for (std::size_t k = 0; k < keys.size(); ++k) keys[k].value = &nodes[k];
  return keys;
}

/// A key without a turn has the axis of its neighbours, so that angles about one axis are what is
/// interpolated.
void share_axis(Track<AxisAngle>& track) {
  const auto turned =
      std::find_if(track.begin(), track.end(), [](const auto& key) { return key.value.angle != 0; });
  if (turned == track.end()) return;
  for (Key<AxisAngle>& key : track)
    if (key.value.angle == 0) key.value.axis = turned->value.axis;
}

}  // namespace

void read_poses(const Node& node, Scope& scope) {
  if (!is_mapping(node, "'poses'", "{smile: {corner_L: {move: [0, 1, 0]}}}", scope.findings)) return;
  for (const Entry& entry : node.entries) {
    if (entry.key.text == rest)
      scope.findings.error(entry.key.where, "a pose cannot be named 'rest'; it stands for the rest pose");
    scope.poses[entry.key.text] = read_pose(entry, scope);
    scope.pose_names.push_back(entry.key.text);
  }
}

MotionTracks read_pose_track(const Node& node, std::string_view handle, std::string_view place,
                             Scope& scope) {
  const std::optional<Fields> fields = read_fields(node, pose_keys, place, scope.findings);
  if (!fields) return {};
  const Easing ease = track_ease(*fields, scope);
  std::vector<Node> nodes;
  std::vector<WrittenKey> keys;
  const Entry *cues = fields->find("cues"), *own = fields->find("keys");
  if (cues != nullptr && own != nullptr) {
    scope.findings.error(std::max(cues, own)->key.where,
                         fmt::format("'keys' and 'cues' exclude each other in {}", place));
  } else if (cues != nullptr) {
    keys = read_cues(cues->value, ease, scope, nodes);
  } else if (const Node* written = require(*fields, "keys", node.where, place, scope.findings)) {
    keys = read_keys(*written, ease, place, scope);
  }
  MotionTracks tracks;
  for (const WrittenKey& key : keys) {
    const std::optional<PosedHandle> posed = posed_by(*key.value, handle, scope);
    if (!posed) continue;
    tracks.move.push_back({key.time, posed->move, key.ease});
    tracks.rotate.push_back({key.time, posed->rotation, key.ease});
    tracks.scale.push_back({key.time, posed->scale, key.ease});
  }
  share_axis(tracks.rotate);
  return tracks;
}

void check_posed_handles(const std::vector<Handle>& handles, Scope& scope) {
  std::vector<std::string> names;
  for (const Handle& handle : handles) names.push_back(handle.name);
  for (const auto& [pose_name, pose] : scope.poses) {
    if (!pose) continue;
    for (const auto& [name, posed] : *pose)
      if (std::find(names.begin(), names.end(), name) == names.end())
        scope.findings.error(posed.where, fmt::format("pose '{}' has an unknown handle '{}'{}", pose_name,
                                                      name, scope.findings.proposal(name, names)));
  }
}

}  // namespace flexkey
