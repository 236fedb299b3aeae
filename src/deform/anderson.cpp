#include "flexkey/deform/anderson.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace flexkey {
namespace {

constexpr double tolerated_growth = 2;  // of the residual over one mixed step
constexpr double independent = 1e-10;   // sin² of the angle between a difference and those newer than it

double longest_stretch(const History& history) {
  double stretch = 0;
  for (int a = 0; a < history.differences(); ++a) {
    const double change = std::sqrt(history.product(a, a));
    if (change > 0) stretch = std::max(stretch, history.way(a) / change);
  }
  return stretch;
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
  stretch_ = longest_stretch(history_);
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
