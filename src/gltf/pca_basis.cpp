#include "flexkey/gltf/pca_basis.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "flexkey/gltf/fitted_basis.h"

namespace flexkey {
namespace {

/// Orthogonal courses over time, the most telling first, as weighted principal components give them.
struct Courses {
  Eigen::MatrixXd values;  // #frames x #courses
  Eigen::MatrixXd fit;     // #courses x #frames; targets = fit · shapes
};

/// How much the frames and the vertices count.
struct Importance {
  Eigen::VectorXd frames, vertices;
};

/// Eigenvectors of √Ω D Λ Dᵀ √Ω, D the shapes, Ω and Λ the importance of frames and vertices.
Courses principal_courses(const ShapeRows& shapes, const Importance& importance) {
  const Eigen::VectorXd root = importance.frames.cwiseSqrt();
  const Eigen::VectorXd columns = importance.vertices.cwiseSqrt().replicate(1, 3).transpose().reshaped();
  const ShapeRows scaled = root.asDiagonal() * shapes * columns.asDiagonal();
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(shapes.rows(), shapes.rows());
  gram.selfadjointView<Eigen::Lower>().rankUpdate(scaled);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram);
  const Eigen::MatrixXd vectors = solver.eigenvectors().rowwise().reverse();
  return {root.cwiseInverse().asDiagonal() * vectors, vectors.transpose() * root.asDiagonal()};
}

/// Each vertex's distance at each frame with the first `count` courses, #frames x #vertices.
Eigen::MatrixXd distances(const ShapeRows& shapes, const Courses& courses, Eigen::Index count) {
  const ShapeRows off = shapes - courses.values.leftCols(count) * (courses.fit.topRows(count) * shapes);
  const Eigen::Index vertices = shapes.cols() / 3;
  Eigen::MatrixXd lengths(shapes.rows(), vertices);
  for (Eigen::Index frame = 0; frame < shapes.rows(); ++frame) {
    const Eigen::Map<const Positions> vectors(off.row(frame).data(), vertices, 3);
    lengths.row(frame) = vectors.rowwise().norm().transpose();
  }
  return lengths;
}

/// The fewest courses within the tolerance; all of them where floats cannot tell.
Eigen::Index fewest_courses(const ShapeRows& shapes, const Courses& courses, double tolerance) {
  Eigen::Index few = 0, enough = courses.values.cols();
  while (few < enough) {
    const Eigen::Index middle = (few + enough) / 2;
    if (distances(shapes, courses, middle).maxCoeff() <= tolerance) {
      enough = middle;
    } else {
      few = middle + 1;
    }
  }
  return enough;
}

/// More importance to what is farther off: what counts is the largest distance, not its squares' sum.
void reweigh(Eigen::VectorXd& importance, const Eigen::VectorXd& errors) {
  importance = importance.cwiseProduct((errors / errors.maxCoeff()).cwiseMax(0.05));
  importance = (importance / importance.maxCoeff()).cwiseMax(1e-4);
}

struct Components {
  Courses courses;
  Eigen::Index count = 0;
};

Components find_components(const ShapeRows& shapes, double tolerance) {
  constexpr int rounds = 5;
  Importance importance{Eigen::VectorXd::Ones(shapes.rows()), Eigen::VectorXd::Ones(shapes.cols() / 3)};
  Components best;
  for (int round = 0; round < rounds; ++round) {
    const Courses courses = principal_courses(shapes, importance);
    const Eigen::Index count = fewest_courses(shapes, courses, tolerance);
    if (round == 0 || count < best.count) best = {courses, count};
    if (count <= 1) break;
    const Eigen::MatrixXd off = distances(shapes, courses, best.count - 1);
    reweigh(importance.vertices, off.colwise().maxCoeff().transpose());
    reweigh(importance.frames, off.rowwise().maxCoeff());
  }
  return best;
}

/// Weights of largest magnitude 1, that one positive.
BasisPlan plan_of(const Components& components, std::span<const int> numbers) {
  BasisPlan plan{{numbers.begin(), numbers.end()},
                 components.courses.values.leftCols(components.count),
                 components.courses.fit.topRows(components.count),
                 {}};
  for (Eigen::Index t = 0; t < components.count; ++t) {
    Eigen::Index at = 0;
    plan.weights.col(t).cwiseAbs().maxCoeff(&at);
    const double scale = plan.weights(at, t);
    plan.weights.col(t) /= scale;
    plan.fit.row(t) *= scale;
    plan.names.push_back(fmt::format("pca_{:03}", t));
  }
  return plan;
}

}  // namespace

Basis pca_basis(const Motion& motion, double tolerance) {
  return fitted_basis(motion, tolerance, [&](const ShapeRows& shapes, double allowed) {
    return plan_of(find_components(shapes, allowed), motion.numbers);
  });
}

}  // namespace flexkey
