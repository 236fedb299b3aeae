#include "table.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace flexkey::bench {
namespace {

/// Characters, not bytes: λ is one.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const Cell& cell, std::size_t width) {
  const std::string space(width - width_of(cell.text), ' ');
  return cell.is_number ? space + cell.text : cell.text + space;
}

/// Each column's width over the header and all rows.
std::vector<std::size_t> widths_of(const Table& table) {
  std::vector<std::size_t> widths;
  for (const std::string& title : table.header) widths.push_back(width_of(title));
  for (const auto& row : table.rows) {
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], width_of(row[k].text));
  }
  return widths;
}

std::string joined(const std::vector<std::string>& parts, const char* between) {
  return fmt::format("{}", fmt::join(parts, between));
}

/// Whether a column holds numbers, which stand at its right.
bool holds_numbers(const Table& table, std::size_t column) {
  return std::any_of(table.rows.begin(), table.rows.end(),
                     [&](const auto& row) { return row[column].is_number; });
}

std::string text_of(const Table& table) {
  const std::vector<std::size_t> widths = widths_of(table);
  std::vector<std::string> titles;
  for (std::size_t k = 0; k < table.header.size(); ++k) {
    const std::string& title = table.header[k];
    titles.push_back(padded(holds_numbers(table, k) ? Cell(title, 0) : Cell(title), widths[k]));
  }
  std::string text = table.title + "\n\n  " + joined(titles, "  ") + "\n";
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (std::size_t k = 0; k < row.size(); ++k) cells.push_back(padded(row[k], widths[k]));
    text += "  " + joined(cells, "  ") + "\n";
  }
  return table.note.empty() ? text : text + "\n  " + table.note + "\n";
}

std::string markdown_of(const Table& table) {
  std::vector<std::string> rules;
  for (std::size_t k = 0; k < table.header.size(); ++k)
    rules.emplace_back(holds_numbers(table, k) ? "--:" : "---");
  std::string text =
      "**" + table.title + "**\n\n| " + joined(table.header, " | ") + " |\n|" + joined(rules, "|") + "|\n";
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (const Cell& cell : row) cells.push_back(cell.text);
    text += "| " + joined(cells, " | ") + " |\n";
  }
  return table.note.empty() ? text : text + "\n" + table.note + "\n";
}

nlohmann::ordered_json json_of(const Table& table) {
  auto rows = nlohmann::ordered_json::array();
  for (const auto& row : table.rows) {
    nlohmann::ordered_json entry;
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (row[k].is_number) {
        entry[table.header[k]] = row[k].value;
      } else {
        entry[table.header[k]] = row[k].text;
      }
    }
    rows.push_back(std::move(entry));
  }
  return {{"title", table.title}, {"note", table.note}, {"rows", std::move(rows)}};
}

std::string all_of(const std::vector<Table>& tables, std::string (*one)(const Table&)) {
  std::vector<std::string> texts;
  for (const Table& table : tables) texts.push_back(one(table));
  return joined(texts, "\n");
}

}  // namespace

Cell seconds(double value) {
  if (value < 0.1) return {fmt::format("{:.3g} ms", 1000 * value), value};
  return {fmt::format("{:.3g} s", value), value};
}

Cell megabytes(double bytes) {
  return {fmt::format("{:.0f} MB", bytes / 1e6), bytes};
}

Cell ratio(double value) {
  return {fmt::format("{:.1f}", value), value};
}

Cell count(double value) {
  return {fmt::format("{:.2f}", value), value};
}

Cell percent(double share) {
  return {fmt::format("{:.1f} %", 100 * share), share};
}

Cell share_of_diagonal(double share) {
  return {fmt::format("{:.1e}", share), share};
}

std::string as_text(const std::vector<Table>& tables) {
  return all_of(tables, text_of);
}

std::string as_markdown(const std::vector<Table>& tables) {
  return all_of(tables, markdown_of);
}

std::string as_json(const std::vector<Table>& tables) {
  auto all = nlohmann::ordered_json::array();
  for (const Table& table : tables) all.push_back(json_of(table));
  return all.dump(2) + "\n";
}

}  // namespace flexkey::bench
