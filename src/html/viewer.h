#pragma once

#include <string_view>

namespace flexkey {

/// The page that tools/viewer builds, as the program holds it. A shot goes to its `@shot@` and `@glb@`.
std::string_view viewer_page();

}  // namespace flexkey
