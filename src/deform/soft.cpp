#include "flexkey/deform/soft.h"

#include "flexkey/deform/factor.h"

namespace flexkey {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

constexpr double no_resistance = 1e-12;  // E as a share of the handle's N_ii: nothing else holds the surface

/// The columns of the identity that are not in a soft handle, free x #rest.
Matrix columns_outside(const std::vector<SoftHandle>& handles, Eigen::Index free) {
  std::vector<bool> is_soft(static_cast<std::size_t>(free), false);
  for (const SoftHandle& handle : handles) {
    for (const int v : handle.vertices) is_soft[v] = true;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (int v = 0; v < free; ++v) {
    if (!is_soft[v]) entries.emplace_back(v, static_cast<int>(entries.size()), 1.0);
  }
  Matrix columns(free, static_cast<Eigen::Index>(entries.size()));
  columns.setFromTriplets(entries.begin(), entries.end());
  return columns;
}

}  // namespace

double strength_of(const Constraints& constraints, int handle) {
  return constraints.strengths.empty() ? 1 : constraints.strengths[handle];
}

int owner_of(const Constraints& constraints, std::size_t k) {
  return constraints.owner.empty() ? 0 : constraints.owner[k];
}

std::vector<SoftHandle> soft_handles(const Constraints& constraints, const std::vector<int>& places,
                                     int free) {
  std::vector<SoftHandle> handles;
  std::vector<int> number(constraints.strengths.size(), -1);  // in `handles`
  for (std::size_t k = 0; k < constraints.handles.size(); ++k) {
    const int handle = owner_of(constraints, k);
    const bool is_free = places[k] >= 0 && places[k] < free;
    if (strength_of(constraints, handle) == 1 || !is_free) continue;
    if (number[handle] < 0) {
      number[handle] = static_cast<int>(handles.size());
      handles.push_back({handle, strength_of(constraints, handle), {}, {}});
    }
    handles[number[handle]].vertices.push_back(places[k]);
    handles[number[handle]].targets.push_back(static_cast<int>(k));
  }
  return handles;
}

Eigen::VectorXd soft_stiffness(const Matrix& N, const std::vector<SoftHandle>& handles) {
  const auto count = static_cast<Eigen::Index>(handles.size());
  Eigen::VectorXd stiffness(count);
  if (count == 0) return stiffness;
  const Matrix outside = columns_outside(handles, N.cols());
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(N.cols(), count);  // of the handles alone
  for (Eigen::Index h = 0; h < count; ++h) {
    for (const int v : handles[h].vertices) moved(v, h) = 1;
  }
  const Factor factor(outside.transpose() * N * outside);
  const Eigen::MatrixXd forces = -(outside.transpose() * (N * moved));
  moved += outside * factor.solve(forces);
  // What is not the handle's has no force left, so that xᵀ N x is the handle's own share of it.
  const Eigen::MatrixXd resistance = N * moved;
  for (Eigen::Index h = 0; h < count; ++h) {
    const SoftHandle& handle = handles[h];
    double energy = 0, own = 0;
    for (const int v : handle.vertices) {
      energy += resistance(v, h);
      own += N.coeff(v, v);
    }
    if (!(energy > no_resistance * own)) energy = own;
    const auto m = static_cast<double>(handle.vertices.size());
    stiffness(h) = energy / m * handle.strength / (1 - handle.strength);
  }
  return stiffness;
}

Springs make_springs(const Matrix& N, const std::vector<SoftHandle>& handles) {
  const Eigen::VectorXd stiffness = soft_stiffness(N, handles);
  Springs springs;
  std::vector<double> each;
  for (std::size_t h = 0; h < handles.size(); ++h) {
    const auto& [handle, strength, vertices, targets] = handles[h];
    springs.vertices.insert(springs.vertices.end(), vertices.begin(), vertices.end());
    springs.targets.insert(springs.targets.end(), targets.begin(), targets.end());
    each.insert(each.end(), vertices.size(), stiffness(static_cast<Eigen::Index>(h)));
  }
  springs.stiffness = Eigen::Map<const Eigen::VectorXd>(each.data(), static_cast<Eigen::Index>(each.size()));
  return springs;
}

Matrix with_springs(Matrix N, const Springs& springs) {
  for (std::size_t k = 0; k < springs.vertices.size(); ++k) {
    N.coeffRef(springs.vertices[k], springs.vertices[k]) += springs.stiffness(static_cast<Eigen::Index>(k));
  }
  return N;
}

void pull(const Springs& springs, const Positions& lacking, Positions& force) {
  for (Eigen::Index k = 0; k < springs.stiffness.size(); ++k) {
    force.row(springs.vertices[k]) += springs.stiffness(k) * lacking.row(k);
  }
}

}  // namespace flexkey
