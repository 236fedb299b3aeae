#include "flexkey/timeline/read_handle.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>
#include <variant>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/play_out.h"
#include "flexkey/timeline/read_active.h"
#include "flexkey/timeline/read_links.h"
#include "flexkey/timeline/read_motion.h"
#include "flexkey/timeline/read_motion_file.h"
#include "flexkey/timeline/read_pose.h"
#include "flexkey/timeline/read_rotate.h"
#include "flexkey/timeline/read_selection.h"
#include "flexkey/timeline/read_sway.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/vector.h"

namespace flexkey {
namespace {

/// Two motions that exclude each other.
struct Exclusion {
  std::string_view one, other;
};

constexpr std::array<Exclusion, 20> exclusions = {{
    {"move", "to"},       {"follow", "move"}, {"follow", "to"},    {"curve", "move"},    {"curve", "to"},
    {"curve", "rotate"},  {"curve", "scale"}, {"curve", "follow"}, {"curve", "wave"},    {"curve", "noise"},
    {"curve", "mirror"},  {"mirror", "move"}, {"mirror", "to"},    {"mirror", "rotate"}, {"mirror", "scale"},
    {"mirror", "follow"}, {"curve", "pose"},  {"curve", "motion"}, {"mirror", "pose"},   {"mirror", "motion"},
}};

void check_exclusions(const Fields& fields, const std::string& place, Scope& scope) {
  for (const auto& [one, other] : exclusions) {
    const Entry* first = fields.find(one);
    const Entry* second = fields.find(other);
    if (first == nullptr || second == nullptr) continue;
    if (second < first) std::swap(first, second);  // entries lie in the file's order
    scope.findings.error(second->key.where, fmt::format("'{}' and '{}' exclude each other in {}",
                                                        first->key.text, second->key.text, place));
  }
}

/// A curve lays an ordered chain of vertices, which only a path selects, and without more rings around it.
void check_curve(const Entry& curve, const Selection& select, const std::string& place, Scope& scope) {
  if (!std::holds_alternative<SelectPath>(select.kind)) {
    scope.findings.error(curve.key.where,
                         fmt::format("'curve' in {} needs an ordered chain of vertices: select it "
                                     "with 'path'",
                                     place));
  } else if (select.grow > 0) {
    scope.findings.error(curve.key.where,
                         fmt::format("'curve' in {} needs the chain alone, without 'grow'", place));
  }
}

double read_weight(const Node& node, Scope& scope) {
  const double weight = read_number(node, scope).value_or(1);
  if (weight > 0 && weight <= 1) return weight;
  scope.findings.error(node.where,
                       fmt::format("weight {} is outside 0..1 (above 0, a soft handle, to 1, which is met "
                                   "exactly)",
                                   node.text));
  return 1;
}

int read_repeat(const Node& node, Scope& scope) {
  constexpr int most = 100'000;
  const std::optional<int> times = read_whole(node, scope);
  if (!times || (*times >= 1 && *times <= most)) return times.value_or(1);
  scope.findings.error(node.where, fmt::format("repeat {} is outside 1..{} times", *times, most));
  return 1;
}

/// {of, plane}; the other handle is found when all are read.
std::optional<Mirror> read_mirror(const Node& node, const std::string& place, HandleLinks& links,
                                  Scope& scope) {
  const std::optional<Fields> fields = read_fields(node, mirror_keys, place, scope.findings);
  if (!fields) return std::nullopt;
  links.mirror_of = require(*fields, "of", node.where, place, scope.findings);
  const Node* plane = require(*fields, "plane", node.where, place, scope.findings);
  if (plane == nullptr) return std::nullopt;
  constexpr std::string_view axes = "xyz";
  const bool is_axis = plane->kind == Node::Kind::scalar && plane->text.size() == 1;
  const std::size_t axis = is_axis ? axes.find(plane->text[0]) : std::string_view::npos;
  if (axis != std::string_view::npos) return Mirror{-1, Vec3::Unit(static_cast<Eigen::Index>(axis))};
  scope.findings.error(plane->where, fmt::format("'plane' is x, y or z, the axis across which left and right "
                                                 "change places, not {}",
                                                 describe(*plane)));
  return std::nullopt;
}

void read_motions(const Fields& fields, const std::string& place, Scope& scope, Handle& handle) {
  const auto of = [&](std::string_view key) { return fmt::format("'{}' of {}", key, place); };
  if (const Node* node = fields.value("move")) handle.move = read_move(*node, of("move"), scope);
  if (const Node* node = fields.value("to")) handle.to = read_to(*node, of("to"), scope);
  if (const Node* node = fields.value("follow")) handle.follow = read_follow(*node, of("follow"), scope);
  if (const Node* node = fields.value("rotate")) {
    Rotation rotation = read_rotate(*node, of("rotate"), scope);
    handle.rotate = std::move(rotation.turns);
    handle.euler = std::move(rotation.euler);
  }
  if (const Node* node = fields.value("scale")) handle.scale = read_scale(*node, of("scale"), scope);
  if (const Node* node = fields.value("curve")) handle.curve = read_curve_track(*node, of("curve"), scope);
  if (const Node* node = fields.value("pose"))
    handle.layers.push_back(read_pose_track(*node, handle.name, of("pose"), scope));
  if (const Node* node = fields.value("motion"))
    handle.layers.push_back(read_motion_file(*node, of("motion"), scope));
  if (const Node* node = fields.value("wave")) handle.waves = read_waves(*node, of("wave"), scope);
  if (const Node* node = fields.value("noise")) handle.noises = read_noises(*node, of("noise"), scope);
}

/// The shot lasts until the handle's last key as it is played.
void read_playing(const Fields& fields, const Entry& entry, Scope& scope, Handle& handle) {
  Playing playing;
  const Node *repeat = fields.value("repeat"), *delay = fields.value("delay");
  if (repeat != nullptr) playing.repeat = read_repeat(*repeat, scope);
  if (delay != nullptr) playing.delay = read_time(*delay, scope).value_or(0);
  const Interval once = keyed_time(handle);
  if (repeat != nullptr && once.from == once.to && !scope.findings.has_errors()) {
    scope.findings.error(repeat->where,
                         fmt::format("handle '{}' repeats no time: it has no two keys", handle.name));
    playing.repeat = 1;
  }
  const double keys = 1 + (once.to - once.from) * scope.fps;
  if (playing.repeat * keys > 1e6) {
    scope.findings.error(repeat->where,
                         fmt::format("repeated {} times, handle '{}' would move for {:.0f} frames; "
                                     "1000000 are the most",
                                     playing.repeat, handle.name, playing.repeat * keys));
    return;
  }
  play_out(playing, scope.fps, handle);
  if (const double last = keyed_time(handle).to; last > scope.last_key) {
    scope.last_key = last;
    scope.last_key_where = (repeat != nullptr ? repeat : delay != nullptr ? delay : &entry.key)->where;
  }
}

std::optional<Handle> read_handle(const Entry& entry, HandleLinks& links, Scope& scope) {
  const std::string place = fmt::format("handle '{}'", entry.key.text);
  const std::optional<Fields> fields = read_fields(entry.value, handle_keys, place, scope.findings);
  if (!fields) return std::nullopt;
  Handle handle;
  handle.name = entry.key.text;
  handle.where = entry.key.where;
  if (const Node* pivot = fields->value("pivot")) handle.pivot = read_point(*pivot, scope);
  read_motions(*fields, place, scope, handle);
  if (const Node* node = fields->value("mirror"))
    handle.mirror = read_mirror(*node, fmt::format("'mirror' of {}", place), links, scope);
  links.parent = fields->value("parent");
  read_playing(*fields, entry, scope, handle);
  if (const Node* node = fields->value("weight")) handle.weight = read_weight(*node, scope);
  read_activity(*fields, place, scope, handle);
  check_exclusions(*fields, place, scope);
  const Node* select = require(*fields, "select", entry.key.where, place, scope.findings);
  if (select == nullptr) return std::nullopt;
  std::optional<Selection> selection = read_selection(*select, fmt::format("'select' of {}", place), scope);
  if (!selection) return std::nullopt;
  if (const Entry* curve = fields->find("curve")) check_curve(*curve, *selection, place, scope);
  handle.select = std::move(*selection);
  return handle;
}

/// What can be said when all handles are known.
void finish(const std::vector<HandleLinks>& links, std::vector<Handle>& handles, Scope& scope) {
  link_handles(links, handles, scope);
  check_posed_handles(handles, scope);
}

}  // namespace

std::vector<Handle> read_handles(const Node& node, Scope& scope) {
  if (!is_mapping(node, "'handles'", "{tip: {select: {axis: z, above: 99%}}}", scope.findings)) return {};
  if (node.entries.empty()) scope.findings.error(node.where, "'handles' names no handle");
  std::vector<Handle> handles;
  std::vector<HandleLinks> links;
  for (const Entry& entry : node.entries) {
    HandleLinks own;
    std::optional<Handle> handle = read_handle(entry, own, scope);
    if (!handle) continue;
    handles.push_back(std::move(*handle));
    links.push_back(own);
  }
  if (handles.size() == node.entries.size()) finish(links, handles, scope);  // else names are missing
  return handles;
}

}  // namespace flexkey
