#include "flexkey/timeline/read_frame_ranges.h"

#include <fmt/format.h>

#include <optional>
#include <span>
#include <string_view>

#include "flexkey/timeline/number.h"

namespace flexkey {
namespace {

/// The ranges of a text, which are behind commas.
void add_ranges(const Node& node, std::vector<FrameRange>& ranges, Scope& scope) {
  std::string_view left = node.kind == Node::Kind::scalar ? std::string_view(node.text) : "";
  for (bool is_last = false; !is_last;) {
    const std::size_t comma = left.find(',');
    is_last = comma == std::string_view::npos;
    std::optional<FrameRange> range = parse_frame_range(trimmed(left.substr(0, comma)));
    if (!range) {
      scope.findings.error(
          node.where,
          fmt::format("{} is not a frame, a range 0-30 or a stepped range 60-90x2", describe(node)));
      return;
    }
    range->where = node.where;
    ranges.push_back(*range);
    if (!is_last) left.remove_prefix(comma + 1);
  }
}

}  // namespace

std::vector<FrameRange> read_frame_ranges(const Node& node, Scope& scope) {
  std::vector<FrameRange> ranges;
  const std::span<const Node> items =
      node.kind == Node::Kind::list ? std::span(node.items) : std::span(&node, 1);
  for (const Node& item : items) add_ranges(item, ranges, scope);
  return ranges;
}

}  // namespace flexkey
