#include "flexkey/deform/local_step.h"

#include <gtest/gtest.h>

#include "deform/plain_steps.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

/// The whole mesh with vertex 0 held.
Patch whole_patch(const Mesh& mesh) {
  std::vector<bool> is_free(mesh.vertex_count(), true);
  is_free[0] = false;
  return make_patch(build_cells(mesh, Weights::cotangent), mesh.positions, is_free, System::least_squares);
}

Transforms unturned(const Patch& patch) {
  return {std::vector<Eigen::Matrix3d>(patch.fitted, Eigen::Matrix3d::Identity()),
          Positions::Ones(patch.fitted, 3)};
}

Transforms fit(const Patch& patch, const Positions& positions, const DeformOptions& options) {
  Transforms transforms = unturned(patch);
  local_step(tabulate(patch), options, positions, transforms);
  return transforms;
}

const std::vector<LocalScale> scale_kinds{LocalScale::axis, LocalScale::uniform, LocalScale::none};

TEST(LocalStep, OfTheRestIsOne) {
  const Patch patch = whole_patch(meshes::bumpy(meshes::sphere(1), 0.1));
  for (const LocalScale kind : scale_kinds) {
    const Transforms at_rest = fit(patch, patch.rest, {.local_scale = kind});
    for (const Eigen::Matrix3d& R : at_rest.rotations)
      EXPECT_LT((R - Eigen::Matrix3d::Identity()).norm(), 1e-15);
    EXPECT_LT((at_rest.scales.array() - 1).abs().maxCoeff(), 1e-15);
  }
}

TEST(LocalStep, OfARigidMotionIsItsRotation) {
  const Patch patch = whole_patch(meshes::bumpy(meshes::grid(4, 3), 0.2));
  const Eigen::Matrix3d turned = meshes::turn(140, {1, -2, 0.5});
  for (const LocalScale kind : scale_kinds) {
    const Transforms moved = fit(patch, meshes::moved(patch.rest, turned, {3, 1, 2}), {.local_scale = kind});
    for (const Eigen::Matrix3d& R : moved.rotations) EXPECT_LT((R - turned).norm(), 1e-12);
    EXPECT_LT((moved.scales.array() - 1).abs().maxCoeff(), 1e-11);
  }
}

TEST(LocalStep, OfAUniformScalingIsItsNumberOnFlatCellsToo) {
  const Patch patch = whole_patch(meshes::grid(4, 3));
  const Positions larger = meshes::moved(patch.rest, 2.5 * meshes::turn(30, {1, 0, 1}), {1, 1, 1});
  for (const LocalScale kind : {LocalScale::axis, LocalScale::uniform}) {
    EXPECT_LT((fit(patch, larger, {.local_scale = kind}).scales.array() - 2.5).abs().maxCoeff(), 1e-12);
  }
}

TEST(LocalStep, AxisWithoutEpsilonFindsAWorldAxisStretch) {
  const Patch patch = whole_patch(meshes::sphere(1));
  const Vec3 stretch(0.5, 1, 3);
  const Transforms found =
      fit(patch, patch.rest * stretch.asDiagonal(), {.local_scale = LocalScale::axis, .epsilon = 0});
  for (int i = 0; i < patch.fitted; ++i) {
    if (patch.vertices[i] >= 6) continue;  // the octahedron's corners: their cells lie evenly about an axis
    EXPECT_LT((found.rotations[i] - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_LT((found.scales.row(i).transpose() - stretch).norm(), 1e-12);
  }
}

using plain::best_scale;

TEST(BestScale, IsTheClosedFormOfItsKind) {
  Eigen::Matrix3d A, C;
  A << 2, 1, 0, 0.5, 3, 1, 0, 0.2, 1;
  C << 1, 0.2, 0, 0.2, 2, 0.1, 0, 0.1, 0.5;
  const Eigen::Matrix3d R = meshes::turn(20, {1, 2, 3});
  const Eigen::Matrix3d AR = A * R.transpose(), RCR = R * C * R.transpose();
  const double uniform = AR.trace() / C.trace();
  const Vec3 paper = AR.diagonal().cwiseQuotient(RCR.diagonal());
  const double e = 0.05;
  const Vec3 drawn = (AR.diagonal().array() + e * AR.trace()) / (RCR.diagonal().array() + e * C.trace());

  EXPECT_EQ(best_scale(A, C, R, {.local_scale = LocalScale::none}), Vec3::Ones());
  EXPECT_LT((best_scale(A, C, R, {.local_scale = LocalScale::uniform}) - Vec3::Constant(uniform)).norm(),
            1e-14);
  EXPECT_LT((best_scale(A, C, R, {.local_scale = LocalScale::axis, .epsilon = 0}) - paper).norm(), 1e-14);
  EXPECT_LT((best_scale(A, C, R, {.local_scale = LocalScale::axis, .epsilon = e}) - drawn).norm(), 1e-14);
}

TEST(BestScale, OfAFlatCellsMissingDirectionIsOneInThePaperForm) {
  const Eigen::Matrix3d C = Vec3(1, 2, 1e-14).asDiagonal(), A = Vec3(3, 4, 5).asDiagonal();
  const Vec3 s =
      best_scale(A, C, Eigen::Matrix3d::Identity(), {.local_scale = LocalScale::axis, .epsilon = 0});
  EXPECT_EQ(s, Vec3(3, 2, 1));
}

TEST(BestScale, OfAnEmptyCellIsOne) {
  const Eigen::Matrix3d zero = Eigen::Matrix3d::Zero();
  for (const LocalScale kind : scale_kinds) {
    for (const double epsilon : {0.0, 0.05}) {
      EXPECT_EQ(
          best_scale(zero, zero, Eigen::Matrix3d::Identity(), {.local_scale = kind, .epsilon = epsilon}),
          Vec3::Ones());
    }
  }
}

TEST(LocalStep, ACollapsedCellKeepsItsRotation) {
  const Patch patch = whole_patch(meshes::tetrahedron());
  Transforms before = unturned(patch);
  for (Eigen::Matrix3d& R : before.rotations) R = meshes::turn(33, {0, 1, 1});
  const Positions point = Positions::Constant(patch.vertex_count(), 3, 0.7);
  Transforms after = before;
  local_step(tabulate(patch), {}, point, after);
  for (const Eigen::Matrix3d& R : after.rotations) EXPECT_EQ(R, before.rotations[0]);
  EXPECT_TRUE(after.scales.allFinite());
}

}  // namespace
}  // namespace flexkey
