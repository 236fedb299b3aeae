#pragma once

#include <Eigen/Core>

namespace flexkey {

/// The rotation R (det +1) with the largest tr(Rᵀ A): weighted Procrustes, the R of least Σ ω |e′ − R e|² for
/// A = Σ ω e′ eᵀ. Where several are best (A of rank 0 or 1, or a reflection whose two smallest singular
/// values are equal) it is the one nearest `previous`, which is a rotation.
Eigen::Matrix3d best_rotation(const Eigen::Matrix3d& A, const Eigen::Matrix3d& previous);

}  // namespace flexkey
