#include "flexkey/timeline/syntax_error.h"

#include <fmt/format.h>
#include <yaml-cpp/exceptions.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace flexkey {
namespace {

namespace messages = YAML::ErrorMsg;

const std::pair<std::string_view, std::string_view> rephrased[] = {
    {messages::END_OF_MAP, "a key is missing here; check the indentation"},
    {messages::END_OF_SEQ, "a '- ' is missing here; check the indentation"},
    {messages::MAP_KEY, "a key cannot stand here; check the indentation"},
    {messages::MAP_VALUE,
     "a ':' cannot stand here; check the indentation and the space after ':' in the line before, or quote "
     "the text"},
    {messages::BLOCK_ENTRY, "a '- ' cannot stand here; check the indentation"},
    {messages::FLOW_END, "this bracket closes nothing that is open"},
    {messages::UNKNOWN_TOKEN, "this character cannot begin a value; quote the text"},
    {messages::UNKNOWN_ANCHOR, "this alias names no anchor above it"},
    {messages::EOF_IN_SCALAR, "a quote is never closed"},
};

/// The offset of a tab among the blanks that begin the line of `offset`.
std::optional<std::size_t> leading_tab(std::string_view text, std::size_t offset) {
  const std::size_t end = std::min(offset, text.size());
  const std::size_t line_break = end == 0 ? std::string_view::npos : text.rfind('\n', end - 1);
  const std::size_t start = line_break == std::string_view::npos ? 0 : line_break + 1;
  const std::size_t first = text.find_first_not_of(' ', start);
  if (first == std::string_view::npos || text[first] != '\t') return std::nullopt;
  return first;
}

std::string describe(const std::string& problem, Mark open) {
  const bool in_map = problem == messages::END_OF_MAP_FLOW;
  if (in_map || problem == messages::END_OF_SEQ_FLOW) {
    return fmt::format("a ',' or '{}' is missing here; the {} began at {}:{}", in_map ? '}' : ']',
                       in_map ? "mapping" : "list", open.line, open.column);
  }
  for (const auto& [yaml, ours] : rephrased) {
    if (problem == yaml) return std::string(ours);
  }
  return "not valid YAML: " + problem;
}

}  // namespace

YamlError syntax_error(const SourceText& source, std::size_t offset, const std::string& problem,
                       Mark innermost_open) {
  if (const std::optional<std::size_t> tab = leading_tab(source.text(), offset)) {
    return {source.mark_at(*tab), "a tab cannot indent a line; use spaces"};
  }
  return {source.mark_at(offset), describe(problem, innermost_open)};
}

}  // namespace flexkey
