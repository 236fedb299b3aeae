#pragma once

#include <string>
#include <string_view>

namespace flexkey {

/// JSON in which an HTML parser finds no tag or comment, whatever names are in it.
std::string script_text(std::string_view json);

}  // namespace flexkey
