#include "flexkey/timeline/variables.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "flexkey/mesh/limits.h"
#include "flexkey/timeline/fields.h"

namespace flexkey {
namespace {

/// A letter or '_' first, then digits too.
bool is_name(std::string_view text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return !text.empty() && !is_digit(text.front()) &&
         std::all_of(text.begin(), text.end(), [&](char c) { return is_letter(c) || is_digit(c); });
}

int depth_of(const Node& node) {
  int deepest_below = 0;
  for (const Node& item : node.items) deepest_below = std::max(deepest_below, depth_of(item));
  for (const Entry& entry : node.entries) deepest_below = std::max(deepest_below, depth_of(entry.value));
  return 1 + deepest_below;
}

std::size_t size_of(const Node& node) {
  std::size_t size = 1;
  for (const Node& item : node.items) size += size_of(item);
  for (const Entry& entry : node.entries) size += 1 + size_of(entry.value);
  return size;
}

/// Replaces `$name` in values, all the way down.
class Substitution {
 public:
  Substitution(const Variables& variables, std::size_t nodes, Findings& findings)
      : variables_(variables), nodes_(nodes), findings_(findings) {}

  void put_into(Node& node, int depth = 1) {
    if (node.kind == Node::Kind::scalar && node.text.size() > 1 && node.text.front() == '$') {
      replace(node, depth);
      return;
    }
    for (Node& item : node.items) put_into(item, depth + 1);
    for (Entry& entry : node.entries) put_into(entry.value, depth + 1);
  }

  std::size_t nodes() const { return nodes_; }

 private:
  void replace(Node& node, int depth) {
    const auto found = variables_.find(std::string_view(node.text).substr(1));
    if (found == variables_.end()) {
      std::vector<std::string> known;
      for (const auto& [name, value] : variables_) known.push_back("$" + name);
      findings_.error(node.where, fmt::format("unknown variable '{}'{}", node.text,
                                              findings_.proposal(node.text, known,
                                                                 "; such names are defined under 'vars'")));
      return;
    }
    if (is_full_) return;
    nodes_ += size_of(found->second);
    if (nodes_ > limits::timeline_values) {
      refuse(node.where,
             fmt::format("with its variables the timeline has more than {} values", limits::timeline_values));
    } else if (depth + depth_of(found->second) > limits::timeline_depth) {
      refuse(node.where,
             fmt::format("with its variables, values are nested more than {} deep", limits::timeline_depth));
    }
    if (is_full_) return;
    const Mark where = node.where;
    node = found->second;
    node.where = where;
  }

  void refuse(Mark where, const std::string& message) {
    findings_.error(where, message);
    is_full_ = true;
  }

  const Variables& variables_;
  std::size_t nodes_;
  bool is_full_ = false;
  Findings& findings_;
};

}  // namespace

Variables put_variables(Node& root, Findings& findings) {
  Variables variables;
  std::size_t nodes = size_of(root);
  const Entry* vars = root.find("vars");
  const Node* defined = vars != nullptr ? &vars->value : nullptr;
  if (defined != nullptr && defined->kind != Node::Kind::null &&
      is_mapping(*defined, "'vars'", "{height: 2}", findings)) {
    for (const Entry& entry : defined->entries) {
      if (!is_name(entry.key.text))
        findings.error(
            entry.key.where,
            fmt::format("'{}' cannot name a variable; use letters, digits and _, with a letter first",
                        entry.key.text));
      Node value = entry.value;
      Substitution above(variables, nodes, findings);
      above.put_into(value);
      nodes = above.nodes();
      variables[entry.key.text] = std::move(value);
    }
  }
  Substitution all(variables, nodes, findings);
  for (Entry& entry : root.entries)
    if (entry.key.text != "vars") all.put_into(entry.value);
  return variables;
}

}  // namespace flexkey
