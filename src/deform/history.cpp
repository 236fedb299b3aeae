#include "flexkey/deform/history.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "flexkey/deform/dispatch.h"

namespace flexkey {
namespace {

constexpr int chunk = 192;  // numbers at a time, whole rows: what a window has of them fits the nearest cache
constexpr int width = 4;    // numbers that are summed side by side

using Four = double __attribute__((vector_size(width * sizeof(double))));
using Loose __attribute__((aligned(sizeof(double)), may_alias)) = Four;  // anywhere in memory

[[gnu::always_inline]] inline double dot(const double* a, const double* b) {
  Four sum{};
  for (int i = 0; i < chunk; i += width) {
    sum += *reinterpret_cast<const Loose*>(a + i) * *reinterpret_cast<const Loose*>(b + i);
  }
  double total = 0;
  for (int l = 0; l < width; ++l) total += sum[l];
  return total;
}

/// A chunk of the last iterate and of every difference.
struct Chunk {
  double *f, *g;
  std::vector<Eigen::VectorXd>&f_changes, &g_changes;
  const std::vector<int>& slots;
  Eigen::Index begin;

  double* f_change(int age) const { return f_changes[slots[age]].data() + begin; }
  double* g_change(int age) const { return g_changes[slots[age]].data() + begin; }
};

/// The numbers of the newest iterate that fall into a chunk, and where the chunk's sums go.
struct Arrival {
  const double *x, *f;
  int size;
  double* sums;
};

/// Files the newest iterate, and its difference with the last where `grew`.
[[gnu::always_inline]] inline void file(const Arrival& in, const Chunk& last, bool grew) {
  if (grew) {
    double *f_change = last.f_change(0), *g_change = last.g_change(0);
    for (int i = 0; i < in.size; ++i) {
      f_change[i] = in.f[i] - last.f[i];
      g_change[i] = in.x[i] + in.f[i] - last.g[i];
    }
  }
  for (int i = 0; i < in.size; ++i) {
    last.f[i] = in.f[i];
    last.g[i] = in.x[i] + in.f[i];
  }
}

/// How many differences there are, and how many of the newest are of this sequence; the first of those is
/// new.
struct Counts {
  int all = 0, own = 0;
};

/// Over the chunk: ‖f‖², Δf_a · f of each a, and of a new difference Δf_a · Δf_0, and Δx_a · Δx_0 of the own.
FLEXKEY_CLONES void arrive(const Arrival& in, const Chunk& at, Counts differences) {
  const bool grew = differences.own > 0;
  file(in, at, grew);
  double* sums = in.sums;
  *sums++ = dot(at.f, at.f);
  for (int a = 0; a < differences.all; ++a) *sums++ = dot(at.f_change(a), at.f);
  if (!grew) return;
  const double *f_change = at.f_change(0), *g_change = at.g_change(0);
  for (int a = 0; a < differences.all; ++a) *sums++ = dot(at.f_change(a), f_change);
  double way[chunk], older[chunk];
  for (int i = 0; i < chunk; ++i) way[i] = g_change[i] - f_change[i];
  for (int a = 0; a < differences.own; ++a) {
    for (int i = 0; i < chunk; ++i) older[i] = at.g_change(a)[i] - at.f_change(a)[i];
    *sums++ = dot(older, way);
  }
}

[[gnu::always_inline]] inline double longest_row(const double* rows, int size) {
  double longest = 0;
  for (int i = 0; i + 2 < size; i += 3) {
    const double square = rows[i] * rows[i] + rows[i + 1] * rows[i + 1] + rows[i + 2] * rows[i + 2];
    longest = square > longest ? square : longest;
  }
  return longest;
}

/// Mixes a chunk; sums: the squares of the longest rows of the jump and of what is left.
FLEXKEY_CLONES void mix_chunk(const Chunk& at, const Eigen::VectorXd& gamma, int size, double* mixed,
                              double* sums) {
  double left[chunk], jump[chunk];
  for (int i = 0; i < size; ++i) {
    mixed[i] = at.g[i];
    left[i] = at.f[i];
  }
  for (int a = 0; a < static_cast<int>(gamma.size()); ++a) {
    const double *f_change = at.f_change(a), *g_change = at.g_change(a);
    const double share = gamma[a];
    for (int i = 0; i < size; ++i) mixed[i] -= share * g_change[i];
    for (int i = 0; i < size; ++i) left[i] -= share * f_change[i];
  }
  for (int i = 0; i < size; ++i) jump[i] = mixed[i] - (at.g[i] - at.f[i]);
  sums[0] = longest_row(jump, size);
  sums[1] = longest_row(left, size);
}

Eigen::Index chunks_of(Eigen::Index numbers) {
  return (numbers + chunk - 1) / chunk;
}

void take_chunks(Eigen::VectorXd& column, Eigen::Index chunks) {
  if (column.size() == 0) column = Eigen::VectorXd::Zero(chunks * chunk);
}

}  // namespace

History::History(int window)
    : slots_(window),
      f_change_(window),
      g_change_(window),
      products_(Eigen::MatrixXd::Zero(window, window)),
      along_(window),
      ways_(window, window) {
  std::iota(slots_.begin(), slots_.end(), 0);
}

void History::add(const Positions& x, const Positions& f) {
  const int window = static_cast<int>(slots_.size());
  const Eigen::Index chunks = chunks_of(x.size());
  const bool grew = follows_;
  if (grew) {
    differences_ = std::min(differences_ + 1, window);
    own_ = std::min(own_ + 1, window);
    std::rotate(slots_.begin(), slots_.end() - 1, slots_.end());
    take_chunks(f_change_[slots_[0]], chunks);
    take_chunks(g_change_[slots_[0]], chunks);
  }
  take_chunks(f_, chunks);
  take_chunks(g_, chunks);
  if (shares_.size() == 0) shares_.resize(3 * window + 1, chunks);
  tbb::parallel_for(Eigen::Index{0}, chunks, [&](Eigen::Index k) {
    const Eigen::Index begin = k * chunk, size = std::min<Eigen::Index>(chunk, x.size() - begin);
    const Arrival arrival{x.data() + begin, f.data() + begin, static_cast<int>(size), shares_.col(k).data()};
    const Chunk at{f_.data() + begin, g_.data() + begin, f_change_, g_change_, slots_, begin};
    arrive(arrival, at, {differences_, own_});
  });
  mixture_.positions.resize(x.rows(), 3);
  follows_ = true;
  sum_up(grew);
}

/// Chunk after chunk, whoever worked them out.
void History::sum_up(bool grew) {
  const int sums = 1 + differences_ + (grew ? differences_ + own_ : 0);
  Eigen::VectorXd total = Eigen::VectorXd::Zero(sums);
  for (Eigen::Index k = 0; k < shares_.cols(); ++k) total += shares_.col(k).head(sums);
  residual_ = std::sqrt(total(0));
  along_.head(differences_) = total.segment(1, differences_);
  if (!grew) return;
  for (int a = 0; a < differences_; ++a)
    products_(slots_[a], slots_[0]) = products_(slots_[0], slots_[a]) = total(differences_ + 1 + a);
  for (int a = 0; a < own_; ++a)
    ways_(slots_[a], slots_[0]) = ways_(slots_[0], slots_[a]) = total(2 * differences_ + 1 + a);
}

const Mixture& History::mix(const Eigen::VectorXd& gamma) {
  Positions& mixed = mixture_.positions;
  tbb::parallel_for(Eigen::Index{0}, shares_.cols(), [&](Eigen::Index k) {
    const Eigen::Index begin = k * chunk, size = std::min<Eigen::Index>(chunk, mixed.size() - begin);
    const Chunk at{f_.data() + begin, g_.data() + begin, f_change_, g_change_, slots_, begin};
    mix_chunk(at, gamma, static_cast<int>(size), mixed.data() + begin, shares_.col(k).data());
  });
  mixture_.jump = std::sqrt(shares_.row(0).maxCoeff());
  mixture_.left = std::sqrt(shares_.row(1).maxCoeff());
  return mixture_;
}

bool History::fits(Eigen::Index rows) const {
  const std::size_t window = static_cast<std::size_t>(along_.size());
  std::vector<int> places(window);
  std::iota(places.begin(), places.end(), 0);
  const bool same_window = f_change_.size() == window && g_change_.size() == window &&
                           products_.rows() == along_.size() && products_.cols() == along_.size();
  if (!same_window || differences_ < 0 || differences_ > along_.size() ||
      !std::is_permutation(slots_.begin(), slots_.end(), places.begin(), places.end()))
    return false;
  const Eigen::Index size = chunks_of(3 * rows) * chunk;
  for (std::size_t age = 0; age < window; ++age) {
    const Eigen::VectorXd &f = f_change_[slots_[age]], &g = g_change_[slots_[age]];
    const bool is_unused = static_cast<int>(age) >= differences_ && f.size() == 0 && g.size() == 0;
    if (!is_unused && (f.size() != size || g.size() != size)) return false;
  }
  return true;
}

}  // namespace flexkey
