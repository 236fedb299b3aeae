#include "flexkey/timeline/read_gltf_output.h"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/read_path.h"
#include "flexkey/timeline/read_pose_outputs.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/words.h"

namespace flexkey {
namespace {

using Basis = GltfOutput::Basis;
using Encoding = GltfOutput::Encoding;

constexpr int most_targets = 65535;  // more overflow the 16-bit counts of common loaders

std::optional<int> read_max_targets(const Node& node, Scope& scope) {
  const std::optional<int> targets = read_whole(node, scope);
  if (!targets || (*targets >= 1 && *targets <= most_targets)) return targets;
  scope.findings.error(node.where, fmt::format("max_targets {} is outside 1..{}", node.text, most_targets));
  return std::nullopt;
}

struct Profile {
  Basis basis;
  Encoding encoding;
};

/// A profile presets basis and encoding; either may still be given singly.
void read_profile(const Fields& fields, GltfOutput& output, Scope& scope) {
  if (const Node* node = fields.value("profile")) {
    const std::optional<Profile> profile =
        read_word<Profile>(*node, "profile",
                           {{"compat", Profile{Basis::knots, Encoding::floats}},
                            {"web", Profile{Basis::pca, Encoding::meshopt}},
                            {"exact", Profile{Basis::frames, Encoding::floats}}},
                           scope);
    if (profile) {
      output.basis = profile->basis;
      output.encoding = profile->encoding;
    }
  }
  if (const Node* node = fields.value("basis")) {
    output.basis =
        read_word<Basis>(*node, "basis",
                         {{"knots", Basis::knots}, {"pca", Basis::pca}, {"frames", Basis::frames}}, scope)
            .value_or(output.basis);
  }
  if (const Node* node = fields.value("encoding")) {
    output.encoding =
        read_word<Encoding>(*node, "encoding", {{"float", Encoding::floats}, {"meshopt", Encoding::meshopt}},
                            scope)
            .value_or(output.encoding);
  }
}

GltfOutput output_at(const Node& path, std::string_view place, Scope& scope) {
  return {.path = read_path(path, place, scope).value_or(""), .where = path.where};
}

/// The text of a name, or nothing and an error.
std::optional<std::string> read_name(const Node& node, std::string_view place, Scope& scope) {
  if (node.kind == Node::Kind::scalar && !node.text.empty()) return node.text;
  scope.findings.error(node.where,
                       fmt::format("{} is a name, not {}", place,
                                   node.kind == Node::Kind::scalar ? "an empty text" : describe(node)));
  return std::nullopt;
}

/// A name, or {name} or {merge_into}.
void read_animation(const Node& node, GltfOutput& output, Scope& scope) {
  if (node.kind != Node::Kind::map) {
    output.animation = read_name(node, "'animation'", scope).value_or("");
    return;
  }
  const std::optional<Fields> fields = read_fields(node, animation_keys, "'animation'", scope.findings);
  if (const Node* name = fields->value("name"))
    output.animation = read_name(*name, "'name' in 'animation'", scope).value_or("");
  const Node* merge = fields->value("merge_into");
  if (merge == nullptr) return;
  output.merge_into = {read_name(*merge, "'merge_into'", scope).value_or(""), merge->where};
  if (!output.animation.empty())
    scope.findings.error(merge->where, "'merge_into' stands beside 'name'; the animation there has its own");
}

std::optional<NamedInterval> read_clip(const Entry& entry, Scope& scope) {
  const Node& node = entry.value;
  if (node.kind != Node::Kind::list || node.items.size() != 2) {
    scope.findings.error(node.where, fmt::format("clip '{}' is [from, to] such as [0s, 1s], not {}",
                                                 entry.key.text, describe(node)));
    return std::nullopt;
  }
  const std::optional<double> from = read_time(node.items[0], scope), to = read_time(node.items[1], scope);
  if (!from || !to) return std::nullopt;
  if (*from < *to) return NamedInterval{entry.key.text, {*from, *to}};
  scope.findings.error(node.where, fmt::format("clip '{}' is from {} to {}, which is no time at all",
                                               entry.key.text, node.items[0].text, node.items[1].text));
  return std::nullopt;
}

}  // namespace

GltfOutput read_gltf_output(const Node& node, std::string_view place, Scope& scope) {
  if (node.kind != Node::Kind::map) return output_at(node, place, scope);
  const std::optional<Fields> fields = read_fields(node, gltf_keys, "'gltf'", scope.findings);
  if (!fields) return {};
  GltfOutput output;
  const Node* path = require(*fields, "path", node.where, "'gltf'", scope.findings);
  if (path != nullptr) output = output_at(*path, "'path' in 'gltf'", scope);
  read_profile(*fields, output, scope);
  if (const Node* tolerance = fields->value("tolerance")) {
    output.tolerance = read_tolerance(*tolerance, scope).value_or(output.tolerance);
  }
  if (const Node* targets = fields->value("max_targets")) {
    output.max_targets = read_max_targets(*targets, scope).value_or(output.max_targets);
  }
  if (const Node* normals = fields->value("normals")) {
    output.normals =
        read_word<bool>(*normals, "normals", {{"smooth", true}, {"none", false}}, scope).value_or(true);
  }
  if (const Node* handles = fields->value("handles")) {
    output.handles = read_switch(*handles, scope).value_or(output.handles);
  }
  if (const Node* split = fields->value("split")) {
    output.split = read_word<bool>(*split, "split", {{"none", false}, {"auto", true}}, scope).value_or(false);
  }
  if (const Node* poses = fields->value("poses")) output.poses = read_pose_outputs(*poses, scope);
  if (const Node* animation = fields->value("animation")) read_animation(*animation, output, scope);
  return output;
}

std::vector<NamedInterval> read_clips(const Node& node, Scope& scope) {
  std::vector<NamedInterval> clips;
  if (node.kind != Node::Kind::map) {
    scope.findings.error(node.where, fmt::format("'clips' is a mapping of names to times, such as "
                                                 "{{walk: [0s, 1s]}}, not {}",
                                                 describe(node)));
    return clips;
  }
  for (const Entry& entry : node.entries) {
    if (const std::optional<NamedInterval> clip = read_clip(entry, scope)) clips.push_back(*clip);
  }
  return clips;
}

}  // namespace flexkey
