#include "flexkey/deform/partition.h"

#include <algorithm>
#include <span>

namespace flexkey {
namespace {

constexpr std::int64_t least_shared = 256 * 1024;  // values; less is solved faster than shared out
constexpr std::int64_t shares = 32;  // whole subtrees stay together up to this part of the values

/// The supernode of each column.
std::vector<int> supernode_of_columns(const Supernodes& L) {
  std::vector<int> supernodes(L.size());
  for (int s = 0; s < L.count(); ++s) {
    std::fill(supernodes.begin() + L.columns[s], supernodes.begin() + L.columns[s + 1], s);
  }
  return supernodes;
}

/// The supernode that holds the first row below each, or -1.
std::vector<int> parents_of(const Supernodes& L) {
  const std::vector<int> supernodes = supernode_of_columns(L);
  std::vector<int> parents(L.count(), -1);
  for (int s = 0; s < L.count(); ++s) {
    if (L.below(s) > 0) parents[s] = supernodes[L.rows[L.row_offsets[s]]];
  }
  return parents;
}

struct Subtree {
  int first = 0;            // supernode; its root is the last
  std::int64_t values = 0;  // in all
};

std::vector<Subtree> subtrees_of(const Supernodes& L, const std::vector<int>& parents) {
  std::vector<Subtree> subtrees(L.count());
  for (int s = 0; s < L.count(); ++s) subtrees[s].first = s;
  for (int s = 0; s < L.count(); ++s) {
    subtrees[s].values += L.value_offsets[s + 1] - L.value_offsets[s];
    if (parents[s] < 0) continue;
    Subtree& above = subtrees[parents[s]];
    above.values += subtrees[s].values;
    above.first = std::min(above.first, subtrees[s].first);
  }
  return subtrees;
}

/// Grows the pieces from the leaves up.
class Cutting {
 public:
  explicit Cutting(std::int64_t limit) : limit_(limit) {}

  /// A whole subtree, with the one beside it under the same parent where both are small.
  void add_subtree(const Subtree& subtree, int end, int parent) {
    const auto [first, values] = subtree;
    const bool is_beside = !loose_.empty() && pieces_[loose_.back()].end == first && loose_parent_ == parent;
    const bool joins = is_beside && loose_values_ + values <= limit_;
    if (joins) {
      pieces_[loose_.back()].end = end;
      loose_values_ += values;
    } else {
      add_piece(first, end);
      loose_values_ = values;
    }
    loose_parent_ = parent;
  }

  /// A supernode above the loose pieces from supernode `lowest` on.
  void add_above(int supernode, int lowest) {
    std::vector<int> below;
    for (; !loose_.empty() && pieces_[loose_.back()].first >= lowest; loose_.pop_back()) {
      below.push_back(loose_.back());
    }
    std::reverse(below.begin(), below.end());
    add_piece(supernode, supernode + 1);
    pieces_.back().below = std::move(below);
    loose_values_ = limit_;  // nothing joins it
  }

  std::vector<Piece> finish(int supernode_count) {
    if (loose_.size() != 1) {
      const std::vector<int> below = loose_;
      add_piece(supernode_count, supernode_count);
      pieces_.back().below = below;
    }
    return std::move(pieces_);
  }

 private:
  void add_piece(int first, int end) {
    loose_.push_back(static_cast<int>(pieces_.size()));
    pieces_.push_back({.first = first, .end = end});
  }

  std::int64_t limit_;
  std::vector<Piece> pieces_;
  std::vector<int> loose_;         // with nothing above them yet, in order
  std::int64_t loose_values_ = 0;  // of the last of them
  int loose_parent_ = 0;           // the supernode above it, or -1
};

std::vector<Piece> cut(const Supernodes& L, std::int64_t limit) {
  const std::vector<int> parents = parents_of(L);
  const std::vector<Subtree> subtrees = subtrees_of(L, parents);
  Cutting cutting(limit);
  for (int s = 0; s < L.count(); ++s) {
    if (subtrees[s].values > limit) {
      cutting.add_above(s, subtrees[s].first);
    } else if (parents[s] < 0 || subtrees[parents[s]].values > limit) {
      cutting.add_subtree(subtrees[s], s + 1, parents[s]);
    }
  }
  return cutting.finish(L.count());
}

/// The columns above the piece that it or a piece below it uses, increasing.
std::vector<int> border_of(const Supernodes& L, const std::vector<Piece>& pieces, const Piece& piece) {
  const int above = L.columns[piece.end];
  std::vector<int> border;
  const auto add = [&](int column) {
    if (column >= above) border.push_back(column);
  };
  std::for_each(L.rows.begin() + L.row_offsets[piece.first], L.rows.begin() + L.row_offsets[piece.end], add);
  for (const int below : piece.below) std::ranges::for_each(pieces[below].border, add);
  std::ranges::sort(border);
  border.erase(std::unique(border.begin(), border.end()), border.end());
  return border;
}

/// The row of x that the piece has for a column of its own or above.
int row_in(const Supernodes& L, const Piece& piece, int column) {
  if (column < L.columns[piece.end]) return column;
  const auto place = std::ranges::lower_bound(piece.border, column);
  return piece.copies + static_cast<int>(place - piece.border.begin());
}

}  // namespace

Partition partition(Supernodes& L) {
  const std::int64_t all = L.value_offsets.back();
  Partition result{cut(L, all < least_shared ? all : all / shares), L.size()};
  for (Piece& piece : result.pieces) {
    piece.border = border_of(L, result.pieces, piece);
    piece.copies = result.rows;
    result.rows += static_cast<int>(piece.border.size());
    for (const int below : piece.below) {
      Piece& child = result.pieces[below];
      for (const int column : child.border) child.originals.push_back(row_in(L, piece, column));
    }
    for (std::int64_t at = L.row_offsets[piece.first]; at < L.row_offsets[piece.end]; ++at) {
      L.rows[at] = row_in(L, piece, L.rows[at]);
    }
  }
  return result;
}

}  // namespace flexkey
