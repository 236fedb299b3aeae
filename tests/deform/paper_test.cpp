#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "deform/dense_paper.h"
#include "deform/plain_steps.h"
#include "flexkey/deform/residual.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

struct Example {
  Mesh rest;
  std::vector<int> held;
  Positions deformed;      // a shape in the middle of a deformation
  Eigen::VectorXd lambda;  // #V
};

/// A bent and stretched bar, held at both ends.
Example bent_bar(Mesh rest) {
  Example example{meshes::bumpy(std::move(rest), 0.15), {}, {}, {}};
  example.held = meshes::between(example.rest, 0, -1, 0.5);
  for (const int v : meshes::between(example.rest, 0, 4.5, 9)) example.held.push_back(v);
  example.deformed = example.rest.positions;
  for (Eigen::Index v = 0; v < example.deformed.rows(); ++v) {
    const Vec3 p = example.deformed.row(v);
    const Eigen::Matrix3d turn = meshes::turn(15 * p.x(), {0.3, 1, 0.5});
    example.deformed.row(v) =
        (turn * Vec3(1.2 * p.x(), p.y() + 0.02 * p.x() * p.x(), 0.9 * p.z())).transpose();
  }
  example.lambda = Eigen::VectorXd::LinSpaced(example.deformed.rows(), 0, 1);
  return example;
}

std::vector<Example> examples() {
  return {bent_bar(meshes::bar(5, 2, 1)), bent_bar(meshes::triangulated(meshes::bar(5, 1, 2)))};
}

/// One plain iteration, the local and the global step, from the example's shape.
Positions one_step(const Example& example, const DeformOptions& options) {
  DeformOptions one = options;
  one.predict = one.accelerate = false;
  one.fixed_count = true;
  one.iterations = 1;
  const Deformer deformer(example.rest, {example.held, {}}, one);
  Pose pose = deformer.pose_at(example.deformed);
  deformer.solve(example.deformed(example.held, Eigen::all), example.lambda, pose);
  return pose.positions;
}

void expect_step_of_the_paper(const Example& example, const DeformOptions& options) {
  const Positions& rest = example.rest.positions;
  const Eigen::MatrixXd W = dense::weights(example.rest, options.weights);
  const Positions r = dense::right_hand_side(W, rest, example.deformed, example.lambda, options);
  const Positions expected = dense::solve(W, r, example.deformed, example.held, options.system);
  const Positions found = one_step(example, options);
  EXPECT_GT((expected - example.deformed).norm(), 0.1);
  EXPECT_LT((found - expected).rowwise().norm().maxCoeff(), 1e-9 * bounds_of(rest).diagonal());
}

TEST(Paper, OneStepIsEquation7WithEquation4) {
  for (const Example& example : examples()) {
    for (const LocalScale kind : {LocalScale::uniform, LocalScale::axis, LocalScale::none}) {
      expect_step_of_the_paper(example, {.local_scale = kind});
    }
    expect_step_of_the_paper(example, {.local_scale = LocalScale::axis, .epsilon = 0});
    expect_step_of_the_paper(example, {.weights = Weights::cotangent});
  }
}

TEST(Paper, OneDirectStepIsEquation5OnTheFreeRows) {
  for (const Example& example : examples()) {
    expect_step_of_the_paper(example, {.system = System::direct});
    expect_step_of_the_paper(example, {.system = System::direct, .local_scale = LocalScale::axis});
  }
}

/// The patch of the example and the local step of its shape.
struct Fitted {
  Patch patch;
  Transforms transforms;
};
Fitted fitted(const Example& example, const DeformOptions& options) {
  std::vector<bool> is_free(example.rest.vertex_count(), true);
  for (const int v : example.held) is_free[v] = false;
  const Cells cells = build_cells(example.rest, options.weights);
  const Patch patch = make_patch(cells, example.rest.positions, is_free, options.system);
  Transforms transforms{std::vector<Eigen::Matrix3d>(patch.fitted, Eigen::Matrix3d::Identity()),
                        Positions::Ones(patch.fitted, 3)};
  local_step(tabulate(patch), options, example.deformed(patch.vertices, Eigen::all), transforms);
  return {patch, transforms};
}

/// r of eq 4: the residual of all positions at the origin.
Positions right_hand_side(const Fitted& at, const Eigen::VectorXd& lambda) {
  Positions r;
  residual(tabulate(at.patch), Positions::Zero(at.patch.vertex_count(), 3), at.transforms, lambda, r);
  return r;
}

TEST(Paper, RightHandSideIsEquation4) {
  for (const Example& example : examples()) {
    const DeformOptions options;
    const Fitted at = fitted(example, options);
    const Patch& patch = at.patch;
    const Positions r = right_hand_side(at, example.lambda(patch.vertices));
    const Eigen::MatrixXd W = dense::weights(example.rest, options.weights);
    const Positions expected =
        dense::right_hand_side(W, example.rest.positions, example.deformed, example.lambda, options);
    for (int i = 0; i < patch.rows; ++i) {
      EXPECT_LT((r.row(i) - expected.row(patch.vertices[i])).norm(), 1e-12);
    }
  }
}

TEST(Paper, LaplacianEditingWithoutScaleTurnsTheDifferentialCoordinates) {
  const Example example = bent_bar(meshes::bar(5, 2, 1));
  const Fitted at = fitted(example, {.local_scale = LocalScale::none});
  const auto& [patch, transforms] = at;
  const Positions r = right_hand_side(at, Eigen::VectorXd::Zero(patch.vertex_count()));
  const Eigen::MatrixXd L = dense::laplacian(dense::weights(example.rest, Weights::clamped));
  const Positions delta = L * example.rest.positions;
  for (int i = 0; i < patch.rows; ++i) {
    const Vec3 expected = transforms.rotations[i] * delta.row(patch.vertices[i]).transpose();
    EXPECT_LT((r.row(i).transpose() - expected).norm(), 1e-12);
  }
}

TEST(Paper, TheFirstSolveFromRestIsTheNaiveLaplacianOne) {
  const Example example = bent_bar(meshes::bar(5, 2, 1));
  const Deformer deformer(example.rest, {example.held, {}}, {.iterations = 1});
  Pose pose = deformer.rest_pose();
  deformer.solve(example.deformed(example.held, Eigen::all), 0.5, pose);

  const Eigen::MatrixXd W = dense::weights(example.rest, Weights::clamped);
  const Positions delta = dense::laplacian(W) * example.rest.positions;
  const Positions expected = dense::solve(W, delta, example.deformed, example.held, System::least_squares);
  EXPECT_LT((pose.positions - expected).norm(), 1e-10);
}

/// Eq 1 summed over all cells.
double arap_energy(const Eigen::MatrixXd& W, const Positions& p, const Positions& p_deformed) {
  double energy = 0;
  for (int i = 0; i < W.rows(); ++i) {
    const Eigen::Matrix3d R = dense::rotation(W, p, p_deformed, i);
    for (int j = 0; j < W.rows(); ++j) {
      const Vec3 e = p.row(i) - p.row(j), e_deformed = p_deformed.row(i) - p_deformed.row(j);
      energy += W(i, j) * (e_deformed - R * e).squaredNorm();
    }
  }
  return energy;
}

TEST(Paper, RigidDirectStepsLowerTheEnergyOfEquation1) {
  for (const Example& example : examples()) {
    const Deformer deformer(example.rest, {example.held, {}},
                            {.system = System::direct,
                             .iterations = 1,
                             .predict = false,
                             .accelerate = false,
                             .fixed_count = true});
    const Eigen::MatrixXd W = dense::weights(example.rest, Weights::clamped);
    Pose pose = deformer.pose_at(example.deformed);
    double energy = arap_energy(W, example.rest.positions, pose.positions);
    for (int k = 0; k < 30; ++k) {
      deformer.solve(example.deformed(example.held, Eigen::all), 1, pose);
      const double next = arap_energy(W, example.rest.positions, pose.positions);
      EXPECT_LT(next, energy);
      energy = next;
    }
  }
}

}  // namespace
}  // namespace flexkey
