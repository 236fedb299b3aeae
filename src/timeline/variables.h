#pragma once

#include <map>
#include <string>

#include "flexkey/timeline/findings.h"
#include "flexkey/timeline/node.h"

namespace flexkey {

/// Values that the timeline names under `vars`.
using Variables = std::map<std::string, Node, std::less<>>;

/// Puts the value of each variable where the tree says `$name`, and returns them all; a variable may use
/// those above it. Reports names that cannot be, and those that are not defined. A tree that would pass the
/// limits with them is left as it is, with an error.
Variables put_variables(Node& root, Findings& findings);

}  // namespace flexkey
