#include "flexkey/deform/dissection.h"

#include <metis.h>

#include <array>
#include <new>
#include <vector>

namespace flexkey {
namespace {

/// The graph of the entries off the diagonal, as METIS takes it.
struct Graph {
  std::vector<idx_t> offsets{0};
  std::vector<idx_t> neighbours;
};

Graph graph_of(const Eigen::SparseMatrix<double>& symmetric) {
  Graph graph;
  graph.offsets.reserve(static_cast<std::size_t>(symmetric.cols()) + 1);
  graph.neighbours.reserve(static_cast<std::size_t>(symmetric.nonZeros()));
  for (Eigen::Index column = 0; column < symmetric.cols(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(symmetric, column); entry; ++entry) {
      if (entry.row() != column) graph.neighbours.push_back(static_cast<idx_t>(entry.row()));
    }
    graph.offsets.push_back(static_cast<idx_t>(graph.neighbours.size()));
  }
  return graph;
}

}  // namespace

Permutation dissection_order(const Eigen::SparseMatrix<double>& symmetric) {
  const auto count = static_cast<idx_t>(symmetric.cols());
  if (count == 0) return Permutation(0);
  Graph graph = graph_of(symmetric);
  std::vector<idx_t> eliminated(symmetric.cols()), places(symmetric.cols());
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_COMPRESS] = 0;  // a surface has hardly two vertices with the same neighbours
  // METIS_NodeND would do the same, but catches SIGTERM meanwhile as if it were a fault of its own, and gives
  // up. This one is for several processes, of whose parts it tells the sizes.
  constexpr idx_t processes = 2;
  std::array<idx_t, 2 * processes> sizes{};
  if (METIS_NodeNDP(count, graph.offsets.data(), graph.neighbours.data(), nullptr, processes, options,
                    eliminated.data(), places.data(), sizes.data()) != METIS_OK) {
    throw std::bad_alloc();
  }
  Permutation order(symmetric.cols());
  for (idx_t i = 0; i < count; ++i) order.indices()[i] = static_cast<int>(places[i]);
  return order;
}

}  // namespace flexkey
