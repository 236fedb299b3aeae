#include <metis.h>

#include <mutex>
#include <new>
#include <vector>

#include "flexkey/deform/ordering.h"

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

Permutation fill_reducing_order(const Eigen::SparseMatrix<double>& symmetric) {
  static std::mutex one_at_a_time;  // METIS draws from libc's one sequence of random numbers
  const std::lock_guard lock(one_at_a_time);
  Graph graph = graph_of(symmetric);
  idx_t count = static_cast<idx_t>(symmetric.cols());
  std::vector<idx_t> eliminated(symmetric.cols());
  std::vector<idx_t> places(symmetric.cols());
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_COMPRESS] = 0;  // a surface has hardly two vertices with the same neighbours
  if (count > 0 && METIS_NodeND(&count, graph.offsets.data(), graph.neighbours.data(), nullptr, options,
                                eliminated.data(), places.data()) != METIS_OK) {
    throw std::bad_alloc();
  }
  Permutation order(symmetric.cols());
  for (idx_t i = 0; i < count; ++i) order.indices()[i] = static_cast<int>(places[i]);
  return order;
}

}  // namespace flexkey
