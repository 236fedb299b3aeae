#include "flexkey/deform/anderson.h"

#include <Eigen/QR>
#include <algorithm>

namespace flexkey {
namespace {

constexpr double tolerated_growth = 2;  // of the residual over one mixed step

Eigen::Map<const Eigen::VectorXd> flat(const Positions& p) {
  return {p.data(), p.size()};
}

}  // namespace

void Anderson::remember(const Positions& x, const Positions& f) {
  dx_.push_back(x - x_);
  df_.push_back(f - f_);
  if (static_cast<int>(dx_.size()) > window_) {
    dx_.pop_front();
    df_.pop_front();
  }
  stretch_ = 0;
  for (std::size_t k = 0; k < dx_.size(); ++k) {
    const double change = df_[k].norm();
    if (change > 0) stretch_ = std::max(stretch_, dx_[k].norm() / change);
  }
}

/// x + f less the combination of ΔG that cancels f best in the least-squares sense.
Positions Anderson::mixture(const Positions& x, const Positions& f) const {
  const auto columns = static_cast<Eigen::Index>(df_.size());
  Eigen::MatrixXd F(f.size(), columns);
  for (Eigen::Index k = 0; k < columns; ++k) F.col(k) = flat(df_[static_cast<std::size_t>(k)]);
  const Eigen::VectorXd gamma = F.colPivHouseholderQr().solve(flat(f));
  Positions mixed = x + f;
  for (std::size_t k = 0; k < df_.size(); ++k)
    mixed -= gamma[static_cast<Eigen::Index>(k)] * (dx_[k] + df_[k]);
  return mixed;
}

Positions Anderson::next(const Positions& x, const Positions& f) {
  const bool first = x_.size() == 0;
  const bool worse = !first && f.norm() > tolerated_growth * f_.norm();
  if (!first) remember(x, f);
  if (worse) {
    dx_.clear();
    df_.clear();
  }
  x_ = x;
  f_ = f;
  if (dx_.empty()) return x + f;
  Positions mixed = mixture(x, f);
  return mixed.allFinite() ? mixed : Positions(x + f);
}

}  // namespace flexkey
