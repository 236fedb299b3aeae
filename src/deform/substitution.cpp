#include "flexkey/deform/substitution.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>

namespace flexkey {
namespace {

/// One pass over the factor.
struct Pass {
  const Substitution& factor;
  const RightHandSides& b;
  double* x;
  int width;
  Sweep forward;
  Sweep backward;
  SupernodeView L;

  double* row(int i) const { return x + static_cast<std::ptrdiff_t>(i) * width; }
};

SupernodeView view_of(const Supernodes& L) {
  return {L.columns.data(), L.row_offsets.data(), L.rows.data(), L.value_offsets.data(), L.values.data()};
}

Pass make_pass(const Substitution& factor, const RightHandSides& b, double* x) {
  const int width = b.width();
  const int choice = std::countr_zero(static_cast<unsigned>(width)) - 2;  // 4, 8, 16
  const Sweeps& sweeps = *factor.sweeps;
  return {factor, b, x, width, sweeps.forward[choice], sweeps.backward[choice], view_of(factor.L)};
}

/// Asks for row i of the right-hand sides, which lie in another order: each would be waited for otherwise.
void fetch(const Pass& pass, int i) {
  const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(pass.factor.rows[i]) * pass.b.stride;
  for (int c = 0; c < pass.b.count; c += pass.b.stride) __builtin_prefetch(pass.b.columns[c] + at);
}

constexpr int fetched_ahead = 16;  // rows

void gather(const Pass& pass, int first, int end) {
  const int last = pass.L.columns[end] - 1;
  for (int i = pass.L.columns[first]; i <= last; ++i) {
    fetch(pass, std::min(i + fetched_ahead, last));
    const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(pass.factor.rows[i]) * pass.b.stride;
    double* x = pass.row(i);
    for (int c = 0; c < pass.b.count; ++c) x[c] = pass.b.columns[c][from];
    for (int c = pass.b.count; c < pass.width; ++c) x[c] = 0;
  }
}

void scatter(const Pass& pass, int first, int end) {
  const int last = pass.L.columns[end] - 1;
  for (int i = pass.L.columns[first]; i <= last; ++i) {
    fetch(pass, std::min(i + fetched_ahead, last));
    const std::ptrdiff_t to = static_cast<std::ptrdiff_t>(pass.factor.rows[i]) * pass.b.stride;
    const double* x = pass.row(i);
    for (int c = 0; c < pass.b.count; ++c) pass.b.columns[c][to] = x[c];
  }
}

void forward(const Pass& pass, const Piece& piece) {
  gather(pass, piece.first, piece.end);
  std::fill_n(pass.row(piece.copies), static_cast<std::ptrdiff_t>(piece.border.size()) * pass.width, 0.0);
  pass.forward(pass.L, piece.first, piece.end, pass.x);
}

void backward(const Pass& pass, const Piece& piece) {
  double* copy = pass.row(piece.copies);
  for (const int i : piece.border) copy = std::copy_n(pass.row(i), pass.width, copy);
  pass.backward(pass.L, piece.first, piece.end, pass.x);
  scatter(pass, piece.first, piece.end);
}

/// What the piece has for the columns above it.
void add_copies(const Pass& pass, const Piece& piece) {
  const double* copy = pass.row(piece.copies);
  for (const int i : piece.border) {
    double* x = pass.row(i);
    for (int c = 0; c < pass.width; ++c) x[c] += *copy++;
  }
}

void solve_top(const Pass& pass) {
  const auto& [pieces, top, rows] = pass.factor.partition;
  for (const SupernodeRange& range : top) gather(pass, range.first, range.end);
  for (const Piece& piece : pieces) add_copies(pass, piece);
  for (const SupernodeRange& range : top) pass.forward(pass.L, range.first, range.end, pass.x);
  for (auto range = top.rbegin(); range != top.rend(); ++range) {
    pass.backward(pass.L, range->first, range->end, pass.x);
    scatter(pass, range->first, range->end);
  }
}

template <class Work>
void for_each_piece(const std::vector<Piece>& pieces, const Work& work) {
  if (pieces.size() == 1) return work(pieces.front());
  tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t p) { work(pieces[p]); });
}

}  // namespace

void substitute(const Substitution& factor, const RightHandSides& b, double* x) {
  const Pass pass = make_pass(factor, b, x);
  for_each_piece(factor.partition.pieces, [&](const Piece& piece) { forward(pass, piece); });
  solve_top(pass);
  for_each_piece(factor.partition.pieces, [&](const Piece& piece) { backward(pass, piece); });
}

}  // namespace flexkey
