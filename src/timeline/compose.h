#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "flexkey/timeline/source_text.h"

namespace flexkey {

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
/// documents, an alias within its own anchor, and more values or levels than limits.h allows.
WrittenNode compose(const SourceText& source);

}  // namespace flexkey
