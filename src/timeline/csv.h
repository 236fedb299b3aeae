#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flexkey {

/// A line of a CSV that has any text.
struct CsvRow {
  int line = 0;  // from 1
  std::vector<std::string> cells;
};

/// Cells between commas, without the spaces around them; one in double quotes may have commas in it, and two
/// double quotes for one. Empty lines and those that begin with "#" are left out. Throws InputError with the
/// line for quotes that do not close.
std::vector<CsvRow> csv_rows(std::string_view text);

}  // namespace flexkey
