#include "flexkey/timeline/read_pose_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace flexkey {
namespace {

std::vector<PoseOutput> all_poses(const Node& node, Scope& scope) {
  std::vector<PoseOutput> outputs;
  if (scope.pose_names.empty())
    scope.findings.error(node.where, "there are no poses; they are defined under 'poses'");
  for (const std::string& name : scope.pose_names)
    if (const std::optional<NamedPose>& pose = scope.poses.at(name))
      outputs.push_back({name, *pose, node.where});
  return outputs;
}

void read_pose_name(const Node& node, std::vector<PoseOutput>& outputs, Scope& scope) {
  if (node.kind != Node::Kind::scalar) {
    scope.findings.error(node.where, fmt::format("a pose is a name, not {}", describe(node)));
    return;
  }
  const bool is_taken = std::any_of(outputs.begin(), outputs.end(),
                                    [&](const PoseOutput& other) { return other.name == node.text; });
  if (is_taken) {
    scope.findings.error(node.where, fmt::format("the pose '{}' stands here twice", node.text));
  } else if (const auto pose = look_up(scope.poses, node, "pose", "poses", scope.findings)) {
    outputs.push_back({node.text, *pose, node.where});
  }
}

}  // namespace

std::vector<PoseOutput> read_pose_outputs(const Node& node, Scope& scope) {
  if (node.kind == Node::Kind::scalar && node.text == "all") return all_poses(node, scope);
  std::vector<PoseOutput> outputs;
  const bool is_list = node.kind == Node::Kind::list;
  for (const Node& name : is_list ? std::span(node.items) : std::span(&node, 1))
    read_pose_name(name, outputs, scope);
  if (is_list && outputs.empty() && node.items.empty())
    scope.findings.error(node.where, "'poses' lists no pose; write all, or names such as [smile]");
  return outputs;
}

}  // namespace flexkey
