#pragma once

#include <vector>

#include "flexkey/deform/supernodes.h"

namespace flexkey {

/// A part of the elimination tree: supernodes `first` to `end`, and below them other pieces or nothing. Of
/// the columns above a piece it uses only its border, which it has copies of; so pieces of which neither is
/// below the other share no row of x.
struct Piece {
  int first = 0;
  int end = 0;
  int copies = 0;                   // the row of x where they begin
  std::vector<int> border = {};     // the columns, increasing
  std::vector<int> originals = {};  // the rows of x that the piece above has for them, #border
  std::vector<int> below = {};      // the pieces right below
};

/// How a solve is shared out. It depends on L alone, so that any number of threads sums in the same order.
struct Partition {
  std::vector<Piece> pieces;  // each behind those below it; the last is above all
  int rows = 0;               // of x: #columns, then the copies of all pieces
};

/// Cuts the tree of L into pieces, and makes the rows of L that are on a piece's border name its copies.
Partition partition(Supernodes& L);

}  // namespace flexkey
