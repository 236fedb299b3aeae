#include "flexkey/deform/elimination_tree.h"

namespace flexkey {

std::vector<int> elimination_tree(const Eigen::SparseMatrix<double>& symmetric, const Permutation& order) {
  const Permutation inverse = order.inverse();
  std::vector<int> parents(order.size(), -1);
  std::vector<int> roots(order.size(), -1);  // shortcuts towards the root of what is joined so far
  for (int column = 0; column < static_cast<int>(parents.size()); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(symmetric, inverse.indices()[column]); entry;
         ++entry) {
      int row = order.indices()[entry.row()];
      while (row != -1 && row < column) {
        const int next = roots[row];
        roots[row] = column;
        if (next == -1) parents[row] = column;
        row = next;
      }
    }
  }
  return parents;
}

std::vector<int> postorder(const std::vector<int>& parents) {
  const int n = static_cast<int>(parents.size());
  std::vector<int> sizes(n, 1);  // of the subtrees; a child comes before its parent
  for (int node = 0; node < n; ++node) {
    if (parents[node] >= 0) sizes[parents[node]] += sizes[node];
  }
  // Going down from the roots, each subtree takes the end of what is left of its parent's range.
  std::vector<int> places(n);
  std::vector<int> free_ends(n);  // of the range that is left for a node's children
  int free_end = n;
  for (int node = n - 1; node >= 0; --node) {
    int& end = parents[node] >= 0 ? free_ends[parents[node]] : free_end;
    places[node] = end - 1;
    free_ends[node] = end - 1;
    end -= sizes[node];
  }
  return places;
}

}  // namespace flexkey
