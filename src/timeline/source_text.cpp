#include "flexkey/timeline/source_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "flexkey/mesh/limits.h"

namespace flexkey {
namespace {

/// Without the byte order mark, and with '\n' for "\r\n" and for a lone '\r'.
std::string with_plain_lines(std::string_view raw) {
  if (raw.starts_with("\xEF\xBB\xBF")) raw.remove_prefix(3);
  std::string text;
  text.reserve(raw.size());
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (raw[i] != '\r') {
      text += raw[i];
    } else if (i + 1 == raw.size() || raw[i + 1] != '\n') {
      text += '\n';
    }
  }
  return text;
}

unsigned byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

/// Bytes of the UTF-8 character at i, or 0 where there is none: RFC 3629, overlong forms and surrogates
/// refused.
std::size_t character_size(std::string_view text, std::size_t i) {
  const unsigned lead = byte_at(text, i);
  if (lead < 0x80) return 1;
  const std::size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || i + size > text.size()) return 0;
  for (std::size_t k = 1; k < size; ++k) {
    if ((byte_at(text, i + k) & 0xC0) != 0x80) return 0;
  }
  const unsigned second = byte_at(text, i + 1);
  const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
  const bool no_character = (lead == 0xED && second > 0x9F) || (lead == 0xF4 && second > 0x8F);
  return overlong || no_character ? 0 : size;
}

bool is_control(unsigned byte) {
  return (byte < 0x20 && byte != '\t' && byte != '\n') || byte == 0x7F;
}

}  // namespace

SourceText::SourceText(std::string_view raw) {
  if (raw.size() > limits::timeline_bytes)
    throw YamlError({1, 1}, fmt::format("the timeline is larger than {} MiB", limits::timeline_bytes >> 20));
  text_ = with_plain_lines(raw);
  line_starts_.push_back(0);
  for (std::size_t i = 0; i < text_.size();) {
    const std::size_t size = character_size(text_, i);
    const unsigned byte = byte_at(text_, i);
    if (size == 0) {
      throw YamlError(mark_at(i),
                      fmt::format("the file is not UTF-8 (byte 0x{:02X}); save it as UTF-8", byte));
    }
    if (is_control(byte)) {
      throw YamlError(mark_at(i),
                      fmt::format("a control character (byte 0x{:02X}) cannot be in a timeline", byte));
    }
    if (byte == '\n') line_starts_.push_back(i + 1);
    for (std::size_t k = 1; k < size; ++k) continuations_.push_back(i + k);
    i += size;
  }
}

Mark SourceText::mark_at(std::size_t offset) const {
  const auto line = std::prev(std::upper_bound(line_starts_.begin(), line_starts_.end(), offset));
  const auto first = std::lower_bound(continuations_.begin(), continuations_.end(), *line);
  const auto last = std::lower_bound(first, continuations_.end(), offset);
  const std::ptrdiff_t column = static_cast<std::ptrdiff_t>(offset - *line) - std::distance(first, last);
  return {static_cast<int>(std::distance(line_starts_.begin(), line)) + 1, static_cast<int>(column) + 1};
}

}  // namespace flexkey
