#pragma once

#include <string>
#include <string_view>

namespace flexkey {

/// The text with every byte that is not part of valid UTF-8 replaced by U+FFFD, since JSON holds nothing
/// else.
std::string valid_utf8(std::string_view text);

}  // namespace flexkey
