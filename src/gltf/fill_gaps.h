#pragma once

#include <string>

namespace flexkey {

/// A file's JSON after things were appended to it: accessors and buffer views that were used before and are
/// no longer give their place to the last of the new ones, so that nothing unused stays behind. What an
/// extension of the file might mean by a number stays where it is.
std::string fill_gaps(const std::string& before, const std::string& after);

}  // namespace flexkey
