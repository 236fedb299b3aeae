#include "flexkey/timeline/frame_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace flexkey {
namespace {

/// What stands at a percent sign.
struct Directive {
  std::size_t length = 0;  // 0: nothing that is known
  int width = 0;           // of the number; 0: "%%"
};

Directive directive_at(std::string_view text) {
  if (text.starts_with("%%")) return {2, 0};
  if (text.starts_with("%d")) return {2, 1};
  if (text.size() < 4 || text[1] != '0' || text[2] < '1' || text[2] > '9' || text[3] != 'd') return {};
  return {4, text[2] - '0'};
}

}  // namespace

std::optional<int> count_frame_numbers(std::string_view pattern) {
  int count = 0;
  for (std::size_t at = pattern.find('%'); at != std::string_view::npos; at = pattern.find('%', at)) {
    const Directive directive = directive_at(pattern.substr(at));
    if (directive.length == 0) return std::nullopt;
    if (directive.width > 0) ++count;
    at += directive.length;
  }
  return count;
}

std::string frame_path(std::string_view pattern, int frame) {
  std::string path;
  while (!pattern.empty()) {
    const std::size_t plain = pattern.find('%');
    path += pattern.substr(0, plain);
    if (plain == std::string_view::npos) break;
    pattern.remove_prefix(plain);
    const Directive directive = directive_at(pattern);
    if (directive.width == 0) {
      path += '%';
    } else {
      fmt::format_to(std::back_inserter(path), "{:0{}}", frame, directive.width);
    }
    pattern.remove_prefix(std::max<std::size_t>(1, directive.length));
  }
  return path;
}

}  // namespace flexkey
