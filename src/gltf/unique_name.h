#pragma once

#include <set>
#include <string>

namespace flexkey {

/// The name, or where it is known already that with a number behind it: "tip", "tip_2". Joins those known.
std::string unique_name(const std::string& name, std::set<std::string>& known);

}  // namespace flexkey
