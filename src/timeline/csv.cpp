#include "flexkey/timeline/csv.h"

#include <fmt/format.h>

#include "flexkey/mesh/error.h"
#include "flexkey/timeline/number.h"

namespace flexkey {
namespace {

/// Takes a cell in quotes from the front of a line, up to what follows its closing quote.
std::string take_quoted(std::string_view& rest, int line) {
  std::string cell;
  rest.remove_prefix(1);
  while (true) {
    const std::size_t quote = rest.find('"');
    if (quote == std::string_view::npos)
      throw InputError(fmt::format("line {}: a double quote is not closed", line));
    cell += rest.substr(0, quote);
    rest.remove_prefix(quote + 1);
    if (!rest.starts_with('"')) return cell;
    cell += '"';
    rest.remove_prefix(1);
  }
}

std::vector<std::string> cells_of(std::string_view rest, int line) {
  std::vector<std::string> cells;
  while (true) {
    rest = trimmed(rest);
    const bool is_quoted = rest.starts_with('"');
    std::string cell = is_quoted ? take_quoted(rest, line) : "";
    const std::size_t comma = rest.find(',');
    const std::string_view plain = trimmed(rest.substr(0, comma));
    if (is_quoted && !plain.empty())
      throw InputError(fmt::format("line {}: '{}' stands behind a cell in quotes", line, plain));
    cells.push_back(is_quoted ? std::move(cell) : std::string(plain));
    if (comma == std::string_view::npos) return cells;
    rest.remove_prefix(comma + 1);
  }
}

}  // namespace

std::vector<CsvRow> csv_rows(std::string_view text) {
  std::vector<CsvRow> rows;
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = text.find('\n');
    std::string_view row = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (row.ends_with('\r')) row.remove_suffix(1);
    if (trimmed(row).empty() || row.starts_with('#')) continue;
    rows.push_back({line, cells_of(row, line)});
  }
  return rows;
}

}  // namespace flexkey
