#include "flexkey/deform/anderson.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace flexkey {
namespace {

constexpr double tolerated_growth = 2;  // of the residual over one mixed step
constexpr double apart = 1e-6;  // of a direction of steps against the longest, squared: below it is rounding
constexpr double least_change = 1e-10;  // ‖Δf‖²/‖Δx‖² that products of differences can show
constexpr double independent = 1e-10;   // sin² of the angle between a difference and those newer than it

/// Largest ‖ΔX c‖/‖ΔF c‖ over the own differences: with ΔX V orthonormal, 1 over the least singular value of
/// ΔF V.
double longest_stretch(const History& history) {
  const int n = history.own();
  Eigen::MatrixXd X(n, n), F(n, n);
  for (int a = 0; a < n; ++a) {
    for (int b = 0; b < n; ++b) {
      const double lengths = std::sqrt(history.way_product(a, a) * history.way_product(b, b));
      X(a, b) = history.way_product(a, b) / lengths;
      F(a, b) = history.product(a, b) / lengths;
    }
  }
  if (n == 0 || !X.allFinite() || !F.allFinite()) return 0;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ways(X);
  const auto spanned = (ways.eigenvalues().array() > apart * ways.eigenvalues()(n - 1)).count();
  const Eigen::MatrixXd V = ways.eigenvectors().rightCols(spanned) *
                            ways.eigenvalues().tail(spanned).cwiseSqrt().cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> changes(V.transpose() * F * V, Eigen::EigenvaluesOnly);
  return 1 / std::sqrt(std::max(changes.eigenvalues()(0), least_change));
}

/// The γ of least ‖f − Σ γ_a Δf_a‖, by the Cholesky factor of the normal equations of the Δf_a/‖Δf_a‖. They
/// know an angle only to half the digits, so that a difference that lies almost within the newer ones gets 0.
Eigen::VectorXd best_mixture(const History& history) {
  const int n = history.differences();
  Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(n, n);  // lower, of the chosen
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  std::vector<int> chosen;
  const auto length = [&](int a) { return std::sqrt(history.product(a, a)); };
  for (int a = 0; a < n; ++a) {
    const auto m = static_cast<Eigen::Index>(chosen.size());
    Eigen::VectorXd row(m);
    for (Eigen::Index k = 0; k < m; ++k)
      row(k) = history.product(a, chosen[k]) / (length(a) * length(chosen[k]));
    factor.topLeftCorner(m, m).triangularView<Eigen::Lower>().solveInPlace(row);
    const double pivot = 1 - row.squaredNorm();
    if (!(length(a) > 0 && pivot > independent)) continue;
    factor.row(m).head(m) = row.transpose();
    factor(m, m) = std::sqrt(pivot);
    right(m) = history.along(a) / length(a);
    chosen.push_back(a);
  }
  const auto m = static_cast<Eigen::Index>(chosen.size());
  const auto L = factor.topLeftCorner(m, m);
  Eigen::VectorXd y = right.head(m), gamma = Eigen::VectorXd::Zero(n);
  L.triangularView<Eigen::Lower>().solveInPlace(y);
  L.transpose().triangularView<Eigen::Upper>().solveInPlace(y);
  for (Eigen::Index k = 0; k < m; ++k) gamma(chosen[k]) = y(k) / length(chosen[k]);
  return gamma;
}

}  // namespace

const Mixture& Anderson::next(const Positions& x, const Positions& f) {
  history_.add(x, f);
  stretch_ = std::max(stretch_, longest_stretch(history_));
  if (before_ > 0 && history_.residual() > tolerated_growth * before_) history_.forget();
  before_ = history_.residual();
  const Eigen::VectorXd gamma = best_mixture(history_);
  return history_.mix(gamma.allFinite() ? gamma : Eigen::VectorXd());
}

void Anderson::turn_to_next_map() {
  history_.part();
  before_ = 0;
}

}  // namespace flexkey
