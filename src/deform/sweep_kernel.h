#pragma once

#include "flexkey/deform/sweep.h"

// The substitution, written once and compiled for each family of processors. See sweep.h for why everything
// here is local to the file that includes it.

namespace flexkey {
namespace {

constexpr int panel_height = 8;  // as Supernodes has it

/// As many numbers as the processor takes at once.
template <int lanes>
struct VectorOf {
  typedef double Type __attribute__((vector_size(lanes * sizeof(double))));
};
template <int lanes>
using Vector = typename VectorOf<lanes>::Type;
static_assert(sizeof(Vector<2>) == 16 && sizeof(Vector<4>) == 32 && sizeof(Vector<8>) == 64);

template <class V>
inline void load(V& to, const double* from) {
  __builtin_memcpy(&to, from, sizeof(V));
}

template <class V>
inline void store(double* to, const V& from) {
  __builtin_memcpy(to, &from, sizeof(V));
}

/// Processors see by themselves that values are read upwards, but not that panels are read downwards.
inline void fetch_before(const double* values) {
  constexpr int ahead = 1024;  // 8 kB: what memory sends while it is waited for
  __builtin_prefetch(values - ahead);
}

/// A panel of a supernode: `values` by columns; x of the panel's columns, of its rows, and all of x.
struct Panel {
  const double* values;
  int columns;
  double* x_columns;
  const int* rows;  // of the panel, where it lies below the run
  double* x;        // of the panel's first row in the run, or of row 0
};

/// x of the rows below −= panel * x of the columns.
template <int lanes, int width>
struct ForwardBelow {
  template <int height>
  static void run(const Panel& panel) {
    for (int lane = 0; lane < width; lane += lanes) {
      Vector<lanes> sums[height] = {};
      for (int c = 0; c < panel.columns; ++c) {
        Vector<lanes> x_c;
        load(x_c, panel.x_columns + c * width + lane);
        for (int r = 0; r < height; ++r) sums[r] += panel.values[c * height + r] * x_c;
      }
      for (int r = 0; r < height; ++r) {
        double* at = panel.x + static_cast<std::int64_t>(panel.rows[r]) * width + lane;
        Vector<lanes> x_r;
        load(x_r, at);
        x_r -= sums[r];
        store(at, x_r);
      }
    }
  }
};

/// x of the columns −= panelᵀ * x of the rows below.
template <int lanes, int width>
struct BackwardBelow {
  template <int height>
  static void run(const Panel& panel) {
    for (int lane = 0; lane < width; lane += lanes) {
      Vector<lanes> x_r[height];
      for (int r = 0; r < height; ++r) {
        load(x_r[r], panel.x + static_cast<std::int64_t>(panel.rows[r]) * width + lane);
      }
      for (int c = 0; c < panel.columns; ++c) {
        // The sum is made before x_c is needed: the panel before this one may still be writing it.
        Vector<lanes> even = {}, odd = {}, x_c;
        fetch_before(panel.values + c * height);
        for (int r = 0; r + 1 < height; r += 2) {
          even += panel.values[c * height + r] * x_r[r];
          odd += panel.values[c * height + r + 1] * x_r[r + 1];
        }
        if (height % 2 == 1) even += panel.values[c * height + height - 1] * x_r[height - 1];
        double* at = panel.x_columns + c * width + lane;
        load(x_c, at);
        x_c -= even + odd;
        store(at, x_c);
      }
    }
  }
};

/// A panel of the run itself: what the columns before it give, then its triangle.
template <int lanes, int width>
struct ForwardWithin {
  template <int height>
  static void run(const Panel& panel) {
    const double* triangle = panel.values + panel.columns * height;
    for (int lane = 0; lane < width; lane += lanes) {
      Vector<lanes> x_r[height];
      for (int r = 0; r < height; ++r) load(x_r[r], panel.x + r * width + lane);
      for (int c = 0; c < panel.columns; ++c) {
        Vector<lanes> x_c;
        load(x_c, panel.x_columns + c * width + lane);
        for (int r = 0; r < height; ++r) x_r[r] -= panel.values[c * height + r] * x_c;
      }
      const double* at = triangle;
      for (int c = 0; c < height; ++c) {
        x_r[c] *= at[0];
        for (int r = c + 1; r < height; ++r) x_r[r] -= at[r - c] * x_r[c];
        at += height - c;
      }
      for (int r = 0; r < height; ++r) store(panel.x + r * width + lane, x_r[r]);
    }
  }
};

template <int lanes, int width>
struct BackwardWithin {
  template <int height>
  static void run(const Panel& panel) {
    const double* end = panel.values + panel.columns * height + height * (height + 1) / 2;
    for (int lane = 0; lane < width; lane += lanes) {
      Vector<lanes> x_r[height];
      for (int r = 0; r < height; ++r) load(x_r[r], panel.x + r * width + lane);
      const double* at = end;
      for (int c = height - 1; c >= 0; --c) {
        at -= height - c;
        for (int r = height - 1; r > c; --r) x_r[c] -= at[r - c] * x_r[r];
        x_r[c] *= at[0];
      }
      for (int r = 0; r < height; ++r) store(panel.x + r * width + lane, x_r[r]);
      for (int c = 0; c < panel.columns; ++c) {
        Vector<lanes> x_c;
        fetch_before(panel.values + c * height);
        load(x_c, panel.x_columns + c * width + lane);
        for (int r = 0; r < height; ++r) x_c -= panel.values[c * height + r] * x_r[r];
        store(panel.x_columns + c * width + lane, x_c);
      }
    }
  }
};

template <class Step>
inline void run(int height, const Panel& panel) {
  switch (height) {
    case 1:
      return Step::template run<1>(panel);
    case 2:
      return Step::template run<2>(panel);
    case 3:
      return Step::template run<3>(panel);
    case 4:
      return Step::template run<4>(panel);
    case 5:
      return Step::template run<5>(panel);
    case 6:
      return Step::template run<6>(panel);
    case 7:
      return Step::template run<7>(panel);
    default:
      return Step::template run<panel_height>(panel);
  }
}

inline int least(int a, int b) {
  return a < b ? a : b;
}

template <int lanes, int width>
void forward(const SupernodeView& L, int first, int end, double* x) {
  const double* values = L.values + L.value_offsets[first];
  for (int s = first; s < end; ++s) {
    const int columns = L.columns[s + 1] - L.columns[s];
    const int below = static_cast<int>(L.row_offsets[s + 1] - L.row_offsets[s]);
    const int* rows = L.rows + L.row_offsets[s];
    double* x_columns = x + static_cast<std::int64_t>(L.columns[s]) * width;
    for (int r = 0; r < columns; r += panel_height) {
      const int height = least(panel_height, columns - r);
      run<ForwardWithin<lanes, width>>(height, {values, r, x_columns, nullptr, x_columns + r * width});
      values += height * r + height * (height + 1) / 2;
    }
    for (int r = 0; r < below; r += panel_height) {
      const int height = least(panel_height, below - r);
      run<ForwardBelow<lanes, width>>(height, {values, columns, x_columns, rows + r, x});
      values += height * columns;
    }
  }
}

/// The panels in the reverse of the order in which they lie.
template <int lanes, int width>
void backward(const SupernodeView& L, int first, int end, double* x) {
  const double* values = L.values + L.value_offsets[end];
  for (int s = end - 1; s >= first; --s) {
    const int columns = L.columns[s + 1] - L.columns[s];
    const int below = static_cast<int>(L.row_offsets[s + 1] - L.row_offsets[s]);
    const int* rows = L.rows + L.row_offsets[s];
    double* x_columns = x + static_cast<std::int64_t>(L.columns[s]) * width;
    for (int r = (below - 1) / panel_height * panel_height; r >= 0 && below > 0; r -= panel_height) {
      const int height = least(panel_height, below - r);
      values -= height * columns;
      run<BackwardBelow<lanes, width>>(height, {values, columns, x_columns, rows + r, x});
    }
    for (int r = (columns - 1) / panel_height * panel_height; r >= 0; r -= panel_height) {
      const int height = least(panel_height, columns - r);
      values -= height * r + height * (height + 1) / 2;
      run<BackwardWithin<lanes, width>>(height, {values, r, x_columns, nullptr, x_columns + r * width});
    }
  }
}

/// most: the numbers that the processor takes at once.
template <int most>
constexpr Sweeps sweeps_of(const char* name) {
  constexpr int lanes = most < 4 ? most : 4;
  return {name,
          {forward<lanes, 4>, forward<most, 8>, forward<most, 16>},
          {backward<lanes, 4>, backward<most, 8>, backward<most, 16>}};
}

}  // namespace
}  // namespace flexkey
