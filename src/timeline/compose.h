#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "flexkey/timeline/source_text.h"

namespace flexkey {

inline constexpr std::size_t most_nodes = 100'000;  // of the document with its aliases expanded
inline constexpr int most_depth = 64;               // of values within values

/// A YAML value as the text has it: aliases and merge keys still stand, doubled keys too.
struct WrittenNode {
  enum class Kind { null, scalar, list, map, alias };
  Kind kind = Kind::null;
  bool plain = true;                  // scalar: without quotes
  bool bare = false;                  // null: the value of a key that stands alone in { }, without ':'
  std::size_t anchor = 0;             // 0: none; of an alias: the anchor that it names
  std::string text;                   // scalar
  std::vector<WrittenNode> children;  // list: items; map: key, value, key, value, …
  Mark where;
};

/// The one document of the text, null if there is none. Throws YamlError for what is not YAML, several
/// documents, an alias within its own anchor, and more than `most_nodes` values or `most_depth` levels.
WrittenNode compose(const SourceText& source);

}  // namespace flexkey
