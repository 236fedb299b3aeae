#pragma once

#include <string_view>

namespace flexkey {

/// The page that tools/viewer builds, as the program holds it. A shot goes to its `@shot@` and `@glb@`.
std::string_view viewer_page();

/// The page on which selections are picked, likewise. A mesh goes to its `@mesh@`.
std::string_view picker_page();

}  // namespace flexkey
