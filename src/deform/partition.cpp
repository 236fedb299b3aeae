#include "flexkey/deform/partition.h"

#include <algorithm>

namespace flexkey {
namespace {

constexpr std::int64_t least_shared = 256 * 1024;  // values; less is solved faster than shared out
constexpr std::int64_t shares = 32;                // a piece is at most this part of the whole

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

/// The largest subtrees of at most `limit` values, neighbours joined up to the limit, and what is above them.
Partition cut(const std::vector<Subtree>& subtrees, const std::vector<int>& parents, std::int64_t limit) {
  Partition result;
  std::int64_t values = 0;  // of the last piece
  for (int s = 0; s < static_cast<int>(subtrees.size()); ++s) {
    const bool within = subtrees[s].values <= limit;
    if (within && parents[s] >= 0 && subtrees[parents[s]].values <= limit) continue;
    if (!within) {
      const bool follows = !result.top.empty() && result.top.back().end == s;
      if (follows)
        ++result.top.back().end;
      else
        result.top.push_back({s, s + 1});
      continue;
    }
    values += subtrees[s].values;
    if (!result.pieces.empty() && result.pieces.back().end == subtrees[s].first && values <= limit) {
      result.pieces.back().end = s + 1;
    } else {
      values = subtrees[s].values;
      result.pieces.push_back({subtrees[s].first, s + 1, 0, {}});
    }
  }
  return result;
}

/// Finds the piece's border and makes its rows name the copies from row `copies` on.
void set_border(Supernodes& L, Piece& piece, int copies) {
  const auto first = L.rows.begin() + L.row_offsets[piece.first];
  const auto end = L.rows.begin() + L.row_offsets[piece.end];
  const int above = L.columns[piece.end];
  std::copy_if(first, end, std::back_inserter(piece.border), [&](int row) { return row >= above; });
  std::sort(piece.border.begin(), piece.border.end());
  piece.border.erase(std::unique(piece.border.begin(), piece.border.end()), piece.border.end());
  piece.copies = copies;
  for (auto row = first; row != end; ++row) {
    if (*row < above) continue;
    const auto place = std::lower_bound(piece.border.begin(), piece.border.end(), *row);
    *row = copies + static_cast<int>(place - piece.border.begin());
  }
}

}  // namespace

Partition partition(Supernodes& L) {
  const std::int64_t all = L.value_offsets.back();
  const std::int64_t limit = all < least_shared ? all : std::max(all / shares, least_shared / 8);
  const std::vector<int> parents = parents_of(L);
  Partition result = cut(subtrees_of(L, parents), parents, limit);
  result.rows = L.size();
  for (Piece& piece : result.pieces) {
    set_border(L, piece, result.rows);
    result.rows += static_cast<int>(piece.border.size());
  }
  return result;
}

}  // namespace flexkey
