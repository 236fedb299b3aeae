#pragma once

#include <cstddef>
#include <string>

#include "flexkey/timeline/source_text.h"

namespace flexkey {

/// A syntax error in words that say what to change. problem: yaml-cpp's message; innermost_open: where the
/// list or mapping began that was being read, line 0 if none.
YamlError syntax_error(const SourceText& source, std::size_t offset, const std::string& problem,
                       Mark innermost_open);

}  // namespace flexkey
