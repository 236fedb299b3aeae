#include "limit.h"

#include <tbb/global_control.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <limits>
#include <vector>

#include "child.h"
#include "clock.h"
#include "flexkey/deform/factor.h"
#include "flexkey/deform/ordering.h"
#include "flexkey/deform/patch.h"
#include "flexkey/mesh/error.h"
#include "motion.h"
#include "statistics.h"

namespace flexkey::bench {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// The shortest of some runs: what the machine can do.
template <class Work>
double best_of(int runs, const Work& work) {
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < runs; ++k) best = std::min(best, seconds_of(cpu_seconds, work));
  return best;
}

/// Bytes a second that one thread reads from memory, far more of it than caches hold.
double read_bandwidth() {
  const Eigen::ArrayXd numbers = Eigen::ArrayXd::Constant(Eigen::Index{1} << 26, 1.0);  // 512 MiB
  double sum = 0;
  const double seconds = best_of(7, [&] { sum += numbers.sum(); });
  if (sum != 7.0 * static_cast<double>(numbers.size())) throw Error("the memory does not add up");
  return static_cast<double>(numbers.size()) * sizeof(double) / seconds;
}

/// L_ff of the motion's surface, free x free.
Matrix free_laplacian(const Motion& motion) {
  std::vector<bool> is_free(motion.mesh.vertex_count(), true);
  for (const int v : motion.constraints.handles) is_free[v] = false;
  const Cells cells = build_cells(motion.mesh, Weights::clamped);
  const Patch patch = make_patch(cells, motion.mesh.positions, is_free, System::direct);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < patch.free; ++i) {
    for (const auto [j, weight] : patch.cells.of(i)) {
      entries.emplace_back(i, i, weight);
      if (j < patch.free) entries.emplace_back(i, j, -weight);
    }
  }
  Matrix laplacian(patch.free, patch.free);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

/// The numbers of the matrix's factor, whatever layout the solver gives them.
double factor_entries(const Matrix& matrix) {
  Matrix ordered;
  ordered = matrix.twistedBy(fill_reducing_order(matrix));
  const Eigen::SimplicialLLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> cholesky(ordered);
  if (cholesky.info() != Eigen::Success) throw Error("the blob's system cannot be factored");
  return static_cast<double>(cholesky.matrixL().nestedExpression().nonZeros());
}

double solve_seconds(const Matrix& matrix) {
  const Factor factor(matrix);
  const Positions b = Positions::Random(matrix.rows(), 3);
  Positions x;
  std::vector<double> seconds;
  for (int k = 0; k < 15; ++k) seconds.push_back(seconds_of(cpu_seconds, [&] { x = factor.solve(b); }));
  return median(seconds);
}

}  // namespace

Limit measure_limit(int blob) {
  const Measured measured = in_child([&]() -> std::vector<double> {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const Motion motion = blob_motion(blob);
    const Matrix matrix = free_laplacian(motion);
    return {static_cast<double>(motion.mesh.vertex_count()), read_bandwidth(),
            sizeof(double) * factor_entries(matrix), solve_seconds(matrix)};
  });
  const auto& values = measured.values;
  return {static_cast<int>(values[0]), values[1], values[2], values[3]};
}

}  // namespace flexkey::bench
