#include "flexkey/timeline/read_vertices.h"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "flexkey/timeline/number.h"

namespace flexkey {
namespace {

std::optional<int> parse_index(std::string_view text) {
  const bool begins_with_digit = !text.empty() && text[0] >= '0' && text[0] <= '9';
  return begins_with_digit ? parse_whole(text) : std::nullopt;
}

std::string problem_of(std::string_view text, std::optional<int> first, std::optional<int> last) {
  if (first && last) return fmt::format("the range '{}' runs backwards", text);
  if (text.starts_with('-') && parse_whole(text))
    return fmt::format("vertex {} does not exist; indices begin at 0", text);
  return fmt::format("'{}' is not a vertex index or a range such as 12-40", text);
}

std::optional<IndexRange> read_range(std::string_view text, Mark where, Scope& scope) {
  text = trimmed(text);
  const std::size_t dash = text.find('-', 1);
  const std::optional<int> first = parse_index(trimmed(text.substr(0, dash)));
  const std::optional<int> last =
      dash == std::string_view::npos ? first : parse_index(trimmed(text.substr(dash + 1)));
  if (first && last && *first <= *last) return IndexRange{*first, *last};
  scope.findings.error(where, problem_of(text, first, last));
  return std::nullopt;
}

/// The ranges of a text such as "0,12-40"; nothing in place of a wrong one.
std::vector<std::optional<IndexRange>> read_text(std::string_view text, Mark where, Scope& scope) {
  std::vector<std::optional<IndexRange>> ranges;
  for (std::size_t comma = text.find(','); comma != std::string_view::npos; comma = text.find(',')) {
    ranges.push_back(read_range(text.substr(0, comma), where, scope));
    text.remove_prefix(comma + 1);
  }
  ranges.push_back(read_range(text, where, scope));
  return ranges;
}

std::vector<std::optional<IndexRange>> read_node(const Node& node, Scope& scope) {
  if (node.kind == Node::Kind::scalar) return read_text(node.text, node.where, scope);
  scope.findings.error(node.where, fmt::format("a vertex index or a range such as 12-40 belongs here, not {}",
                                               describe(node)));
  return {std::nullopt};
}

}  // namespace

std::optional<std::vector<IndexRange>> read_index_ranges(const Node& node, Scope& scope) {
  std::vector<std::optional<IndexRange>> parts;
  if (node.kind == Node::Kind::list) {
    for (const Node& item : node.items) {
      for (const std::optional<IndexRange>& part : read_node(item, scope)) parts.push_back(part);
    }
  } else {
    parts = read_node(node, scope);
  }
  if (parts.empty()) scope.findings.error(node.where, "'vertices' lists no vertex");
  std::vector<IndexRange> ranges;
  for (const std::optional<IndexRange>& part : parts) {
    if (part) ranges.push_back(*part);
  }
  if (ranges.empty() || ranges.size() < parts.size()) return std::nullopt;
  return ranges;
}

}  // namespace flexkey
