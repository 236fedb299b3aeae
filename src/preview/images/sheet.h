#pragma once

#include <string>
#include <vector>

#include "flexkey/preview/picture.h"

namespace flexkey {

/// Pictures side by side on white, as a figure of a paper: chosen times in a row, or a row a time and a
/// column a value of λ.
struct Sheet {
  int columns = 1;
  std::vector<Picture> cells;              // row by row, all of one size; the last row may be short
  std::vector<std::string> column_labels;  // above the columns; none, or one each
  std::vector<std::string> row_labels;     // left of the rows; none, or one each
};

/// Where a sheet's cells lie, pixels. Cell (row, column) begins at (left + column * (cell_width + gap),
/// top + row * (cell_height + gap)).
struct SheetLayout {
  int width = 0, height = 0;
  int left = 0, top = 0;
  int cell_width = 0, cell_height = 0;
  int gap = 0;
  int text_size = 0;
};

/// Throws InputError where a sheet has no cells, cells of several sizes or another number of labels.
SheetLayout layout_of(const Sheet& sheet);

Picture draw_sheet(const Sheet& sheet);

}  // namespace flexkey
