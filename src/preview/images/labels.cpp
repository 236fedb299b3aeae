#include "flexkey/preview/images/labels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "flexkey/preview/images/text.h"

namespace flexkey {
namespace {

enum class Side { left, right };

/// The labels of one side, downwards by their places.
using Column = std::vector<Label>;

/// Of the text, pixels: what is easy to read, or as much as a full column has room for.
int text_size(const Picture& picture, std::size_t count) {
  const int usual = std::max(11, picture.height / 40);
  const int room = picture.height / (2 * static_cast<int>(std::max<std::size_t>(1, count)));
  return std::clamp(room, 6, usual);
}

/// The middles of a column's lines: each at its place's height, moved apart as far as they must be.
std::vector<double> heights_of(const Column& column, double line, double height) {
  std::vector<double> heights;
  for (const Label& label : column)
    heights.push_back(heights.empty() ? std::max(label.at.y, line)
                                      : std::max(label.at.y, heights.back() + line));
  double end = height - line;
  for (std::size_t k = heights.size(); k-- > 0; end = heights[k] - line)
    heights[k] = std::min(heights[k], end);
  return heights;
}

void draw_label(Picture& picture, const Label& label, double middle, Side side, int size) {
  const int space = size * 2 / 3, width = text_width(label.text, size), box_height = size + space;
  const int left = side == Side::left ? space : picture.width - space - width - 2 * space;
  const int top = static_cast<int>(std::lround(middle)) - box_height / 2;
  const double edge = side == Side::left ? left + width + 2 * space : left;
  const std::array line{Point{edge, middle}, label.at};
  draw_line(picture, line, std::max(1.0, size / 9.0), {label.colour, 0.8f});
  draw_line(picture, std::span(&label.at, 1), size / 2.5, {label.colour});
  fill(picture, {left, top, width + 2 * space, box_height}, {colour_from_srgb(255, 255, 255), 0.85f});
  fill(picture, {side == Side::left ? left : left + width + 2 * space - 3, top, 3, box_height},
       {label.colour});
  write_text(picture, left + space, top + (box_height + digit_height(size)) / 2, label.text,
             {size, colour_from_srgb(38, 38, 44)});
}

void draw_column(Picture& picture, Column column, Side side) {
  std::stable_sort(column.begin(), column.end(),
                   [](const Label& a, const Label& b) { return a.at.y < b.at.y; });
  const int size = text_size(picture, column.size());
  const std::vector<double> heights = heights_of(column, 1.8 * size, picture.height);
  for (std::size_t k = 0; k < column.size(); ++k) draw_label(picture, column[k], heights[k], side, size);
}

}  // namespace

void draw_labels(Picture& picture, const std::vector<Label>& labels) {
  Column left, right;
  for (const Label& label : labels) (label.at.x < picture.width / 2.0 ? left : right).push_back(label);
  draw_column(picture, std::move(left), Side::left);
  draw_column(picture, std::move(right), Side::right);
}

}  // namespace flexkey
