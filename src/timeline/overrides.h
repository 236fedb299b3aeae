#pragma once

#include <string>

#include "flexkey/timeline/node.h"
#include "flexkey/timeline/parse.h"

namespace flexkey {

/// The tree with the value at `change.key_path` replaced; missing mappings are made. A part of the path is a
/// key (the longest that is there, so that "keys.1.5s" finds the key "1.5s") or the index of a list item,
/// from 0. number: of the override on the command line, from 1; everything that it puts into the tree has the
/// mark {0, number}.
Node with_override(Node root, const Override& change, int number, Findings& findings);

/// A key path and where it stands.
struct KeyPath {
  std::string text;
  Mark where;
};

/// Puts a value into the tree likewise, with the marks that it has.
void put_value(Node& root, const KeyPath& key, Node value, Findings& findings);

/// The tree with all of it at one place.
Node marked(Node node, Mark where);

}  // namespace flexkey
