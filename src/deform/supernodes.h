#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace flexkey {

/// A lower triangular L in supernodes: runs of columns whose rows below the run are the same, so that each is
/// a dense trapezoid and a solve reads its values once, in the order in which they lie.
///
/// Supernode s holds the columns from columns[s] to columns[s + 1]. Its values are a row of panels, each of
/// `panel_height` rows or of what is left, stored by columns. First come the rows of the run itself: what is
/// left of the panel's own columns, then its triangle by columns, with 1/L_kk on the diagonal. Then come the
/// rows below the run, all columns wide.
struct Supernodes {
  static constexpr int panel_height = 8;

  std::vector<int> columns{0};               // #supernodes + 1, the first column of each
  std::vector<std::int64_t> row_offsets{0};  // #supernodes + 1, into rows
  std::vector<int> rows;                     // the rows below each run, increasing
  std::vector<std::int64_t> value_offsets;   // #supernodes + 1, into values
  std::vector<double> values;

  int count() const { return static_cast<int>(columns.size()) - 1; }
  int size() const { return columns.back(); }
  int width(int s) const { return columns[s + 1] - columns[s]; }
  int below(int s) const { return static_cast<int>(row_offsets[s + 1] - row_offsets[s]); }
};

/// Makes room for the values of the columns and rows given.
void allocate_values(Supernodes& L);

/// block: the trapezoid of supernode s, by columns, `height` apart; what lies above the diagonal is not read.
void pack(Supernodes& L, int s, const double* block, std::int64_t height);

/// L_kk, #columns.
Eigen::VectorXd diagonal(const Supernodes& L);

std::size_t bytes(const Supernodes& L);

}  // namespace flexkey
