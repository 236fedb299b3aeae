#include "flexkey/deform/history.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "flexkey/deform/dispatch.h"

namespace flexkey {
namespace {

constexpr int lanes = 4;           // numbers that are summed side by side
constexpr int chunk = 64 * lanes;  // numbers at a time: what a window has of them fits the nearest cache

using Eight = double __attribute__((vector_size(lanes * sizeof(double)), aligned(sizeof(double)), may_alias));

[[gnu::always_inline]] inline double dot(const double* a, const double* b) {
  Eight sum{};
  for (int i = 0; i < chunk; i += lanes) {
    sum += *reinterpret_cast<const Eight*>(a + i) * *reinterpret_cast<const Eight*>(b + i);
  }
  double total = 0;
  for (int l = 0; l < lanes; ++l) total += sum[l];
  return total;
}

/// A chunk of a matrix with a column an iterate.
struct Columns {
  double* first;          // of column 0
  std::ptrdiff_t stride;  // from column to column
  const int* slots;       // the columns, the newest first

  double* of(int age) const { return first + stride * slots[age]; }
};

Columns chunk_of(Eigen::MatrixXd& values, Eigen::Index begin, const std::vector<int>& slots) {
  return {values.data() + begin, values.rows(), slots.data()};
}

/// The numbers of the newest iterate that fall into a chunk, and where the chunk's sums go.
struct Arrival {
  const double *x, *f;
  int size;
  double* sums;
};

/// Files the newest iterate and sums over the chunk: Δf_a · Δf_0 and Δf_a · f of each a, ‖Δx_0‖², ‖f‖².
FLEXKEY_CLONES void file(const Arrival& in, const Columns& f, const Columns& g, int differences) {
  double *f_new = f.of(0), *g_new = g.of(0), *sums = in.sums;
  for (int i = 0; i < in.size; ++i) {
    f_new[i] = in.f[i];
    g_new[i] = in.x[i] + in.f[i];
  }
  double newest[chunk] = {}, way[chunk] = {};
  if (differences > 0) {
    const double *f_before = f.of(1), *g_before = g.of(1);
    for (int i = 0; i < in.size; ++i) {
      newest[i] = f_new[i] - f_before[i];
      way[i] = in.x[i] - (g_before[i] - f_before[i]);
    }
  }
  for (int a = 0; a < differences; ++a) {
    const double *after = f.of(a), *before = f.of(a + 1);
    double change[chunk];
    for (int i = 0; i < chunk; ++i) change[i] = after[i] - before[i];
    *sums++ = dot(change, newest);
    *sums++ = dot(change, f_new);
  }
  *sums++ = dot(way, way);
  *sums++ = dot(f_new, f_new);
}

FLEXKEY_CLONES void mix_chunk(const Columns& g, const Eigen::VectorXd& gamma, int size, double* mixed) {
  const double* newest = g.of(0);
  for (int i = 0; i < size; ++i) mixed[i] = newest[i];
  for (int a = 0; a < static_cast<int>(gamma.size()); ++a) {
    const double *after = g.of(a), *before = g.of(a + 1);
    const double share = gamma[a];
    for (int i = 0; i < size; ++i) mixed[i] -= share * (after[i] - before[i]);
  }
}

}  // namespace

History::History(int window)
    : slots_(window + 1), products_(window + 1, window + 1), along_(window), way_(window + 1) {
  std::iota(slots_.begin(), slots_.end(), 0);
}

void History::add(const Positions& x, const Positions& f) {
  const auto columns = static_cast<Eigen::Index>(slots_.size());
  const Eigen::Index chunks = (x.size() + chunk - 1) / chunk;
  if (differences_ < 0) {
    f_ = g_ = Eigen::MatrixXd::Zero(chunks * chunk, columns);
    mixed_.resize(x.rows(), 3);
    shares_.resize(2 * columns, chunks);
  }
  differences_ = std::min(differences_ + 1, static_cast<int>(columns) - 1);
  std::rotate(slots_.begin(), slots_.end() - 1, slots_.end());
  tbb::parallel_for(Eigen::Index{0}, chunks, [&](Eigen::Index k) {
    const Eigen::Index begin = k * chunk, size = std::min<Eigen::Index>(chunk, x.size() - begin);
    const Arrival arrival{x.data() + begin, f.data() + begin, static_cast<int>(size), shares_.col(k).data()};
    file(arrival, chunk_of(f_, begin, slots_), chunk_of(g_, begin, slots_), differences_);
  });
  sum_up();
}

/// Chunk after chunk, whoever worked them out.
void History::sum_up() {
  const int sums = 2 * differences_ + 2;
  Eigen::VectorXd total = Eigen::VectorXd::Zero(sums);
  for (Eigen::Index k = 0; k < shares_.cols(); ++k) total += shares_.col(k).head(sums);
  for (int a = 0; a < differences_; ++a) {
    products_(slots_[a], slots_[0]) = products_(slots_[0], slots_[a]) = total(2 * a);
    along_(a) = total(2 * a + 1);
  }
  way_(slots_[0]) = std::sqrt(total(sums - 2));
  residual_ = std::sqrt(total(sums - 1));
}

const Positions& History::mix(const Eigen::VectorXd& gamma) {
  tbb::parallel_for(Eigen::Index{0}, shares_.cols(), [&](Eigen::Index k) {
    const Eigen::Index begin = k * chunk, size = std::min<Eigen::Index>(chunk, mixed_.size() - begin);
    mix_chunk(chunk_of(g_, begin, slots_), gamma, static_cast<int>(size), mixed_.data() + begin);
  });
  return mixed_;
}

}  // namespace flexkey
