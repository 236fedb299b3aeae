#include "flexkey/timeline/table_lines.h"

#include <algorithm>

namespace flexkey {
namespace {

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view between = " \t,;\r";
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(between); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(between, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(between, end);
  }
  return words;
}

}  // namespace

void for_each_line(std::string_view text,
                   const std::function<void(int line, const std::vector<std::string_view>& words)>& take) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view content = text.substr(0, end);
    content = content.substr(0, content.find('#'));
    const std::vector<std::string_view> words = words_of(content);
    if (!words.empty()) take(line, words);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace flexkey
