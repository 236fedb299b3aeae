#pragma once

#include <string>

namespace flexkey::cli {

/// Names this build of the program: the identifier that the linker made of its contents, in hexadecimal, or
/// its version where the linker made none.
std::string build_id();

}  // namespace flexkey::cli
