#pragma once

#include <functional>
#include <string_view>
#include <vector>

namespace flexkey {

/// The words of each line of a table in text, between tabs, spaces, commas or semicolons; lines without
/// words, and what follows "#", are left out. line: from 1.
void for_each_line(std::string_view text,
                   const std::function<void(int line, const std::vector<std::string_view>& words)>& take);

}  // namespace flexkey
