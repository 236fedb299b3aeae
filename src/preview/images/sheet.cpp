#include "flexkey/preview/images/sheet.h"

#include <fmt/format.h>

#include <algorithm>

#include "flexkey/mesh/error.h"
#include "flexkey/preview/images/draw.h"
#include "flexkey/preview/images/text.h"

namespace flexkey {
namespace {

int rows_of(const Sheet& sheet) {
  return (static_cast<int>(sheet.cells.size()) + sheet.columns - 1) / sheet.columns;
}

void check_labels(const std::vector<std::string>& labels, int wanted, const char* what) {
  if (!labels.empty() && static_cast<int>(labels.size()) != wanted)
    throw InputError(fmt::format("a sheet with {} {} has {} labels for them", wanted, what, labels.size()));
}

void check_sheet(const Sheet& sheet) {
  if (sheet.cells.empty() || sheet.columns < 1) throw InputError("a sheet of no pictures");
  const Picture& first = sheet.cells.front();
  for (const Picture& cell : sheet.cells)
    if (cell.width != first.width || cell.height != first.height)
      throw InputError(fmt::format("a sheet with pictures of {} x {} and {} x {} pixels", first.width,
                                   first.height, cell.width, cell.height));
  check_labels(sheet.column_labels, sheet.columns, "columns");
  check_labels(sheet.row_labels, rows_of(sheet), "rows");
}

int widest(const std::vector<std::string>& labels, int size) {
  int width = 0;
  for (const std::string& label : labels) width = std::max(width, text_width(label, size));
  return width;
}

}  // namespace

SheetLayout layout_of(const Sheet& sheet) {
  check_sheet(sheet);
  SheetLayout layout;
  layout.cell_width = sheet.cells.front().width;
  layout.cell_height = sheet.cells.front().height;
  layout.gap = std::clamp(layout.cell_width / 64, 2, 12);
  layout.text_size = std::clamp(layout.cell_height / 14, 10, 32);
  const int margin = 2 * layout.gap, space = layout.text_size / 2;
  layout.left = margin;
  layout.top = margin;
  if (!sheet.row_labels.empty()) layout.left += widest(sheet.row_labels, layout.text_size) + space;
  if (!sheet.column_labels.empty()) layout.top += digit_height(layout.text_size) + space;
  layout.width = layout.left + sheet.columns * (layout.cell_width + layout.gap) - layout.gap + margin;
  layout.height = layout.top + rows_of(sheet) * (layout.cell_height + layout.gap) - layout.gap + margin;
  return layout;
}

Picture draw_sheet(const Sheet& sheet) {
  const SheetLayout at = layout_of(sheet);
  Picture picture = blank_picture(at.width, at.height, colour_from_srgb(255, 255, 255));
  const auto cell_left = [&](int column) { return at.left + column * (at.cell_width + at.gap); };
  const auto cell_top = [&](int row) { return at.top + row * (at.cell_height + at.gap); };
  for (int i = 0; i < static_cast<int>(sheet.cells.size()); ++i)
    paste(picture, sheet.cells[static_cast<std::size_t>(i)], cell_left(i % sheet.columns),
          cell_top(i / sheet.columns));

  const int space = at.text_size / 2;
  TextStyle style{at.text_size, colour_from_srgb(40, 40, 44), Align::centre};
  for (int column = 0; column < static_cast<int>(sheet.column_labels.size()); ++column)
    write_text(picture, cell_left(column) + at.cell_width / 2, at.top - space,
               sheet.column_labels[static_cast<std::size_t>(column)], style);
  style.align = Align::right;
  for (int row = 0; row < static_cast<int>(sheet.row_labels.size()); ++row)
    write_text(picture, at.left - space, cell_top(row) + (at.cell_height + digit_height(at.text_size)) / 2,
               sheet.row_labels[static_cast<std::size_t>(row)], style);
  return picture;
}

}  // namespace flexkey
