#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "flexkey/timeline/findings.h"

namespace flexkey {

struct Entry;

/// A value of the timeline, aliases and merge keys followed: what every reader reads.
struct Node {
  enum class Kind { null, scalar, list, map };
  Kind kind = Kind::null;
  std::string text;            // scalar
  std::vector<Node> items;     // list
  std::vector<Entry> entries;  // map, in the file's order, merged ones last; no key twice
  Mark where;                  // of an absent value: of its key

  const Entry* find(std::string_view key) const;
};

struct Entry {
  Node key;  // a scalar
  Node value;
};

/// "a list", "a mapping", "'abc'" or "an empty value": what a node is, for messages.
std::string describe(const Node& node);

/// The document as a tree. Throws YamlError for what cannot be read at all (see `compose`); the rest (keys
/// that are doubled, not one word, or alone between two commas) goes to the findings and is left out of the
/// tree.
Node parse_yaml(std::string_view text, Findings& findings);

}  // namespace flexkey
