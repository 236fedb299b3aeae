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

double* copies(const Pass& pass, const Piece& piece) {
  return pass.row(piece.copies);
}

/// What a piece has for the columns above it.
void add_copies(const Pass& pass, const Piece& piece) {
  const double* copy = copies(pass, piece);
  for (const int i : piece.originals) {
    double* x = pass.row(i);
    for (int c = 0; c < pass.width; ++c) x[c] += *copy++;
  }
}

void make_copies(const Pass& pass, const Piece& piece) {
  double* copy = copies(pass, piece);
  for (const int i : piece.originals) copy = std::copy_n(pass.row(i), pass.width, copy);
}

/// Works on the pieces right below, each by itself.
template <class Work>
void for_each_below(const Pass& pass, const Piece& piece, const Work& work) {
  const std::vector<Piece>& pieces = pass.factor.partition.pieces;
  if (piece.below.empty()) return;
  if (piece.below.size() == 1) return work(pieces[piece.below.front()]);
  tbb::parallel_for(std::size_t{0}, piece.below.size(), [&](std::size_t i) { work(pieces[piece.below[i]]); });
}

void forward(const Pass& pass, const Piece& piece) {
  for_each_below(pass, piece, [&](const Piece& below) { forward(pass, below); });
  gather(pass, piece.first, piece.end);
  std::fill_n(copies(pass, piece), static_cast<std::ptrdiff_t>(piece.border.size()) * pass.width, 0.0);
  for (const int below : piece.below) add_copies(pass, pass.factor.partition.pieces[below]);
  pass.forward(pass.L, piece.first, piece.end, pass.x);
}

void backward(const Pass& pass, const Piece& piece) {
  make_copies(pass, piece);
  pass.backward(pass.L, piece.first, piece.end, pass.x);
  scatter(pass, piece.first, piece.end);
  for_each_below(pass, piece, [&](const Piece& below) { backward(pass, below); });
}

}  // namespace

void substitute(const Substitution& factor, const RightHandSides& b, double* x) {
  const Pass pass = make_pass(factor, b, x);
  forward(pass, factor.partition.pieces.back());
  backward(pass, factor.partition.pieces.back());
}

}  // namespace flexkey
