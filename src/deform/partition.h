#pragma once

#include <vector>

#include "flexkey/deform/supernodes.h"

namespace flexkey {

/// Whole subtrees of the elimination tree, one behind the other: supernodes `first` to `end`. They read and
/// write no column of another piece, and of the columns above them only their border's, of which they have
/// copies of their own, from row `copies` on.
struct Piece {
  int first = 0;
  int end = 0;
  int copies = 0;
  std::vector<int> border;  // columns above the piece, increasing
};

struct SupernodeRange {
  int first = 0;
  int end = 0;
};

/// How a solve is shared out. It depends on L alone, so that any number of threads sums in the same order.
struct Partition {
  std::vector<Piece> pieces;        // independent of each other
  std::vector<SupernodeRange> top;  // what is above them, in order
  int rows = 0;                     // of x: #columns, then the copies of all borders
};

/// Cuts the tree of L into pieces, and makes the rows of L that are a piece's border name its copies.
Partition partition(Supernodes& L);

}  // namespace flexkey
