#include "flexkey/deform/supernodes.h"

#include <algorithm>

namespace flexkey {
namespace {

constexpr int panel_height = Supernodes::panel_height;

std::int64_t triangle_size(std::int64_t n) {
  return n * (n + 1) / 2;
}

/// `block` begins at the panel's first row.
double* pack_panel(const double* block, std::int64_t height, int rows, int columns, double* to) {
  for (int c = 0; c < columns; ++c) to = std::copy_n(block + c * height, rows, to);
  return to;
}

/// `block` begins at the triangle's first entry.
double* pack_triangle(const double* block, std::int64_t height, int rows, double* to) {
  for (int c = 0; c < rows; ++c) {
    const double* column = block + c * height;
    *to++ = 1 / column[c];
    to = std::copy(column + c + 1, column + rows, to);
  }
  return to;
}

}  // namespace

void allocate_values(Supernodes& L) {
  L.value_offsets.assign(1, 0);
  for (int s = 0; s < L.count(); ++s) {
    const std::int64_t width = L.width(s);
    L.value_offsets.push_back(L.value_offsets.back() + triangle_size(width) + width * L.below(s));
  }
  L.values.resize(static_cast<std::size_t>(L.value_offsets.back()));
}

void pack(Supernodes& L, int s, const double* block, std::int64_t height) {
  const int width = L.width(s);
  const int all = width + L.below(s);
  double* to = L.values.data() + L.value_offsets[s];
  for (int row = 0; row < width; row += panel_height) {
    const int rows = std::min(panel_height, width - row);
    to = pack_panel(block + row, height, rows, row, to);
    to = pack_triangle(block + row * height + row, height, rows, to);
  }
  for (int row = width; row < all; row += panel_height) {
    to = pack_panel(block + row, height, std::min(panel_height, all - row), width, to);
  }
}

Eigen::VectorXd diagonal(const Supernodes& L) {
  Eigen::VectorXd roots(L.size());
  for (int s = 0; s < L.count(); ++s) {
    const double* at = L.values.data() + L.value_offsets[s];
    for (int row = 0; row < L.width(s); row += panel_height) {
      const int rows = std::min(panel_height, L.width(s) - row);
      at += rows * row;
      for (int c = 0; c < rows; ++c) {
        roots[L.columns[s] + row + c] = 1 / *at;
        at += rows - c;
      }
    }
  }
  return roots;
}

std::size_t bytes(const Supernodes& L) {
  return L.columns.capacity() * sizeof(int) + L.row_offsets.capacity() * sizeof(std::int64_t) +
         L.rows.capacity() * sizeof(int) + L.value_offsets.capacity() * sizeof(std::int64_t) +
         L.values.capacity() * sizeof(double);
}

}  // namespace flexkey
