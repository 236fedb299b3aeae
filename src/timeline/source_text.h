#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/selection.h"

namespace flexkey {

/// A text that is not YAML at all, or not within the bounds of a timeline; nothing after it can be read.
class YamlError : public Error {
 public:
  YamlError(Mark where, const std::string& message) : Error(message), where_(where) {}
  Mark where() const { return where_; }

 private:
  Mark where_;
};

/// The text of a timeline, made plain: UTF-8 without byte order mark, lines ending in '\n'.
class SourceText {
 public:
  /// Throws YamlError for a text over limits::timeline_bytes, one that is not UTF-8, and control characters.
  explicit SourceText(std::string_view raw);

  const std::string& text() const { return text_; }
  /// Line and column of a byte; columns count characters, as editors do.
  Mark mark_at(std::size_t offset) const;

 private:
  std::string text_;
  std::vector<std::size_t> line_starts_;    // byte offsets
  std::vector<std::size_t> continuations_;  // byte offsets of the second and later bytes of a character
};

}  // namespace flexkey
