#include <cholmod.h>
#include <fmt/format.h>

#include <memory>
#include <mutex>
#include <new>
#include <vector>

#include "flexkey/deform/cholesky.h"
#include "flexkey/deform/dissection.h"
#include "flexkey/deform/ordering.h"

extern "C" {  // in headers whose names are others in each distribution, or of the compiler's own OpenMP
void openblas_set_num_threads(int);
int openblas_get_num_threads();
void omp_set_max_active_levels(int);
int omp_get_max_active_levels();
}

namespace flexkey {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// While it lives CHOLMOD and its BLAS work in the calling thread alone: their own threads mostly wait for
/// each other at the sizes of a surface's supernodes, which takes a third of the time more, and they would
/// compete with those of the program.
class OneThread {
 public:
  OneThread() {
    omp_set_max_active_levels(0);
    openblas_set_num_threads(1);
  }
  ~OneThread() {
    omp_set_max_active_levels(levels_);
    openblas_set_num_threads(threads_);
  }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int levels_ = omp_get_max_active_levels();
  int threads_ = openblas_get_num_threads();
};

/// Parts of L_ff up to this size minimum degree orders in a fifth of the time, for 5 % more fill in all. In
/// L_fᵀ L_f it fills a fifth more, so that it is dissected all the way down.
constexpr std::size_t least_dissected = 6000;  // vertices

/// CHOLMOD's settings and work space.
struct Session {
  OneThread one_thread;
  cholmod_common common;

  Session() {
    cholmod_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.final_ll = 1;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
    common.postorder = 1;
    common.zrelax[0] = 0.5;  // fewer zeros in small supernodes than its 0.8: every frame reads them
    common.quick_return_if_not_posdef = 1;
    common.current = 0;
    common.method[0].nd_small = least_dissected;
    common.method[0].nd_compress = 0;  // a surface has hardly two vertices with the same neighbours
  }
  ~Session() { cholmod_finish(&common); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
};

struct FreeFactor {
  cholmod_common* common;
  void operator()(cholmod_factor* factor) const { cholmod_free_factor(&factor, common); }
};
using FactorPointer = std::unique_ptr<cholmod_factor, FreeFactor>;

/// The upper triangle, seen as CHOLMOD sees it; CHOLMOD writes nothing in it.
cholmod_sparse upper_triangle(const Matrix& matrix) {
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(matrix.cols());
  view.nzmax = static_cast<std::size_t>(matrix.nonZeros());
  view.p = const_cast<int*>(matrix.outerIndexPtr());
  view.i = const_cast<int*>(matrix.innerIndexPtr());
  view.x = const_cast<double*>(matrix.valuePtr());
  view.stype = 1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

Supernodes packed(const cholmod_factor& factor) {
  const auto* columns = static_cast<const int*>(factor.super);
  const auto* row_begins = static_cast<const int*>(factor.pi);
  const auto* value_begins = static_cast<const int*>(factor.px);
  const auto* rows = static_cast<const int*>(factor.s);
  Supernodes L;
  L.columns.assign(columns, columns + factor.nsuper + 1);
  for (int s = 0; s < L.count(); ++s) {  // CHOLMOD lists a supernode's own columns among its rows
    L.rows.insert(L.rows.end(), rows + row_begins[s] + L.width(s), rows + row_begins[s + 1]);
    L.row_offsets.push_back(static_cast<std::int64_t>(L.rows.size()));
  }
  allocate_values(L);
  for (int s = 0; s < L.count(); ++s) {
    pack(L, s, static_cast<const double*>(factor.x) + value_begins[s], row_begins[s + 1] - row_begins[s]);
  }
  return L;
}

/// Whether each vertex has few neighbours, as in L_ff; L_fᵀ L_f has three times as many.
bool is_thin(const Matrix& symmetric) {
  return symmetric.nonZeros() <= 12 * symmetric.cols();
}

void require_memory(const cholmod_common& common) {
  if (common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE) throw std::bad_alloc();
}

}  // namespace

Permutation fill_reducing_order(const Matrix& symmetric) {
  static std::mutex one_at_a_time;  // CHOLMOD's dissection is METIS's too
  const std::lock_guard lock(one_at_a_time);
  if (!is_thin(symmetric)) return dissection_order(symmetric);
  Session session;
  cholmod_sparse view = upper_triangle(symmetric);
  Permutation inverse(symmetric.cols());
  inverse.setIdentity();  // which stays where there are no entries, a matrix that CHOLMOD refuses
  std::vector<int> parts(2 * view.ncol);  // two results that nothing asks for
  cholmod_nested_dissection(&view, nullptr, 0, inverse.indices().data(), parts.data(),
                            parts.data() + view.ncol, &session.common);
  require_memory(session.common);
  return inverse.inverse();
}

std::optional<Cholesky> cholesky(const Matrix& matrix, const Permutation& order) {
  Session session;
  cholmod_sparse view = upper_triangle(matrix);
  Eigen::VectorXi eliminated = Permutation(order.inverse()).indices();
  const FactorPointer factor(cholmod_analyze_p(&view, eliminated.data(), nullptr, 0, &session.common),
                             FreeFactor{&session.common});
  if (factor != nullptr) cholmod_factorize(&view, factor.get(), &session.common);
  require_memory(session.common);
  if (session.common.status != CHOLMOD_OK || factor->minor < factor->n) return std::nullopt;
  const Eigen::Map<const Eigen::VectorXi> composed(static_cast<const int*>(factor->Perm), matrix.cols());
  return Cholesky{Permutation(composed).inverse(), packed(*factor)};
}

std::string factoring_library() {
  int version[3];
  cholmod_version(version);
  return fmt::format("CHOLMOD {}.{}.{}", version[0], version[1], version[2]);
}

}  // namespace flexkey
