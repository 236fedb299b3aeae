#pragma once

#include <string>
#include <utility>
#include <vector>

namespace flexkey::bench {

/// A cell as people read it, and the number behind it: seconds, bytes, shares, counts.
struct Cell {
  std::string text;
  double value = 0;
  bool is_number = false;
  Cell(std::string words) : text(std::move(words)) {}  // NOLINT: words are cells
  Cell(const char* words) : text(words) {}             // NOLINT
  Cell(std::string shown, double number) : text(std::move(shown)), value(number), is_number(true) {}
};

struct Table {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<Cell>> rows = {};  // each as long as the header
  std::string note = {};                     // a sentence below the table
};

Cell seconds(double value);  // "12 ms"
Cell megabytes(double bytes);
Cell ratio(double value);  // "12.3"
Cell count(double value);  // "3.42"
Cell percent(double share);
Cell share_of_diagonal(double share);  // "1.2e-03"

std::string as_text(const std::vector<Table>& tables);
std::string as_markdown(const std::vector<Table>& tables);
/// A list of {title, note, rows: [{column: value}]}, numbers in seconds, bytes and shares.
std::string as_json(const std::vector<Table>& tables);

}  // namespace flexkey::bench
