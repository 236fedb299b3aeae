#include "flexkey/deform/soft.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>

#include "flexkey/deform/prediction.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

/// A bar along z whose low end is held, and whose high end is led by a handle of this strength.
struct SoftBar {
  Mesh mesh;
  Constraints constraints;
  std::vector<int> low, high;

  SoftBar(int width, double strength) : mesh(meshes::bar(width, width, 4 * width)) {
    low = meshes::between(mesh, 2, 0, 0);
    high = meshes::between(mesh, 2, 4 * width, 4 * width);
    constraints.handles = low;
    constraints.handles.insert(constraints.handles.end(), high.begin(), high.end());
    constraints.owner.assign(constraints.handles.size(), 0);
    std::fill(constraints.owner.begin() + static_cast<std::ptrdiff_t>(low.size()), constraints.owner.end(),
              1);
    constraints.strengths = {1, strength};
  }

  Positions rest_targets() const { return mesh.positions(constraints.handles, Eigen::all); }
  Positions targets(const Vec3& move) const {
    Positions targets = rest_targets();
    targets.bottomRows(static_cast<Eigen::Index>(high.size())).rowwise() += move.transpose();
    return targets;
  }
};

double largest(const Positions& difference) {
  return difference.rowwise().norm().maxCoeff();
}

// The surface turns with the handle, which then goes farther than on a surface that cannot turn.
TEST(Soft, AHandleGoesAboutTheShareOfTheWayThatItsStrengthSays) {
  for (const System system : {System::least_squares, System::direct})
    for (const int level : {3, 4})
      for (const double strength : {0.5, 0.9}) {
        const Mesh mesh = meshes::sphere(level);
        const std::vector<int> low = meshes::between(mesh, 2, -1, -0.2),
                               cap = meshes::between(mesh, 2, 0.85, 1);
        Constraints constraints{low, {}, std::vector<int>(low.size(), 0), {1, strength}};
        constraints.handles.insert(constraints.handles.end(), cap.begin(), cap.end());
        constraints.owner.resize(constraints.handles.size(), 1);
        Positions targets = mesh.positions(constraints.handles, Eigen::all);
        const Eigen::RowVector3d move(0.3, 0, 0.5);
        targets.bottomRows(static_cast<Eigen::Index>(cap.size())).rowwise() += move;
        const Deformer deformer(mesh, constraints, {.system = system, .iterations = 500});
        Pose pose = deformer.rest_pose();
        EXPECT_TRUE(deformer.solve(targets, 0.5, pose).converged);
        const Positions way = pose.positions(cap, Eigen::all) - mesh.positions(cap, Eigen::all);
        const double share = way.colwise().mean().dot(move) / move.squaredNorm();
        EXPECT_GT(share, strength == 0.5 ? 0.55 : 0.91) << "level " << level << " strength " << strength;
        EXPECT_LT(share, strength == 0.5 ? 0.71 : 0.95) << "level " << level << " strength " << strength;
      }
}

TEST(Soft, WhileTheSurfaceDoesNotTurnAVertexGoesExactlyItsShare) {
  const Mesh mesh = meshes::bumpy(meshes::bar(2, 2, 6), 0.1);
  Constraints constraints{meshes::between(mesh, 2, -1, 0.5), {}, {}, {1, 0.3}};
  constraints.owner.assign(constraints.handles.size(), 0);
  const int tip = meshes::between(mesh, 2, 5.5, 7).front();
  constraints.handles.push_back(tip);
  constraints.owner.push_back(1);
  const Eigen::RowVector3d move(0.3, 1, 2);
  for (const System system : {System::least_squares, System::direct}) {
    // From rest with R = S = 1, the first step is linear in the targets.
    const Deformer deformer(mesh, constraints,
                            {.system = system, .iterations = 1, .predict = false, .accelerate = false});
    Pose pose = deformer.rest_pose();
    Positions targets = mesh.positions(constraints.handles, Eigen::all);
    targets.bottomRows(1) += move;
    deformer.solve(targets, 0.7, pose);
    EXPECT_LT((pose.positions.row(tip) - mesh.positions.row(tip) - 0.3 * move).norm(), 1e-10);
  }
}

TEST(Soft, TheEnergyIsTheLeastOfMovingTheHandleByOne) {
  // A chain of springs 1 - 2 - 3 between a fixed end and three vertices, of which the last is the handle.
  Eigen::MatrixXd N(3, 3);
  N << 3, -2, 0, -2, 5, -3, 0, -3, 3;
  const double in_series = 1 / (1.0 / 1 + 1.0 / 2 + 1.0 / 3);
  const std::vector<SoftHandle> handle = {{0, 0.75, {2}, {0}}};
  EXPECT_NEAR(soft_stiffness(N.sparseView(), handle)(0), 3 * in_series, 1e-14);
  // Two handles: each is moved while the other stays.
  const std::vector<SoftHandle> two = {{0, 0.5, {0}, {0}}, {1, 0.5, {2}, {1}}};
  const double middle = 1 / (1.0 / 2 + 1.0 / 3);
  EXPECT_NEAR(soft_stiffness(N.sparseView(), two)(0), 1 + middle, 1e-14);
  EXPECT_NEAR(soft_stiffness(N.sparseView(), two)(1), middle, 1e-14);
}

TEST(Soft, AlmostHardIsAlmostMetAndHardIsMetExactly) {
  const Vec3 move(0.5, 1, -0.5);
  const SoftBar soft(3, 1 - 1e-7), hard(3, 1);
  const Deformer nearly(soft.mesh, soft.constraints, {.iterations = 500, .tolerance = 1e-7});
  const Deformer met(hard.mesh, hard.constraints, {.iterations = 500, .tolerance = 1e-7});
  Pose a = nearly.rest_pose(), b = met.rest_pose();
  nearly.solve(soft.targets(move), 0.5, a);
  met.solve(hard.targets(move), 0.5, b);
  EXPECT_LT(largest(a.positions - b.positions), 1e-4);
  EXPECT_EQ(Positions(b.positions(hard.constraints.handles, Eigen::all)), hard.targets(move));
  EXPECT_NE(Positions(a.positions(soft.high, Eigen::all)), Positions(b.positions(hard.high, Eigen::all)));
}

TEST(Soft, ARigidMotionOfAllHandlesIsReachedInOneSolve) {
  for (const std::vector<double>& strengths : {std::vector<double>{1, 0.4}, std::vector<double>{0.6, 0.4}}) {
    SoftBar bar(2, 0.4);
    bar.constraints.strengths = strengths;
    const Eigen::AngleAxisd turn(1.2, Vec3(1, 2, 0.5).normalized());
    const Positions moved = meshes::moved(bar.mesh.positions, turn.toRotationMatrix(), {3, -1, 2});
    Positions turns(2, 3);
    turns.rowwise() = (turn.angle() * turn.axis()).transpose();
    for (const System system : {System::least_squares, System::direct}) {
      const Deformer deformer(bar.mesh, bar.constraints, {.system = system, .iterations = 1});
      Pose pose = deformer.rest_pose();
      deformer.solve({moved(bar.constraints.handles, Eigen::all), turns}, 0.5, pose);
      EXPECT_LT(largest(pose.positions - moved), 1e-9);
    }
  }
}

TEST(Soft, ASurfaceThatOneSoftHandleHoldsGoesAllTheWay) {
  const Mesh mesh = meshes::bumpy(meshes::bar(3, 2, 2), 0.1);
  const Constraints constraints{{0, 5, 9}, {}, {0, 0, 0}, {0.2}};
  for (const System system : {System::least_squares, System::direct}) {
    const Deformer deformer(mesh, constraints, {.system = system, .iterations = 200});
    Pose pose = deformer.rest_pose();
    Positions targets = mesh.positions(constraints.handles, Eigen::all);
    targets.rowwise() += Eigen::RowVector3d(1, 2, 3);
    deformer.solve(targets, 0.5, pose);
    EXPECT_LT(largest(pose.positions - meshes::moved(mesh.positions, meshes::turn(0, {1, 0, 0}), {1, 2, 3})),
              1e-9);
  }
}

TEST(Soft, AFrameAtRestIsTheRest) {
  const SoftBar bar(2, 0.5);
  const Deformer deformer(bar.mesh, bar.constraints);
  Pose pose = deformer.rest_pose();
  EXPECT_EQ(deformer.solve(bar.rest_targets(), 0.5, pose).solves, 0);
  EXPECT_EQ(pose.positions, bar.mesh.positions);
  deformer.solve(bar.targets({0, 1, 0}), 0.5, pose);
  deformer.solve(bar.rest_targets(), 0.5, pose);
  EXPECT_LT(largest(pose.positions - bar.mesh.positions), 1e-2);
}

TEST(Soft, TheHarmonicWeightsSumToOne) {
  const SoftBar bar(2, 0.3);
  const Cells cells = build_cells(bar.mesh, Weights::clamped);
  std::vector<bool> is_free(static_cast<std::size_t>(bar.mesh.vertex_count()), true);
  std::vector<int> owner(is_free.size(), -1);
  for (const int v : bar.low) {
    is_free[v] = false;
    owner[v] = 0;
  }
  for (const int v : bar.high) owner[v] = 1;
  const Patch patch = make_patch(cells, bar.mesh.positions, is_free, System::direct);
  SoftHandle soft{1, 0.3, {}, {}};
  for (int i = 0; i < patch.free; ++i) {
    if (owner[patch.vertices[i]] == 1) soft.vertices.push_back(i);
  }
  const Eigen::MatrixXd weights = harmonic_weights(cells, patch, owner, 2, {{soft}, {}});
  EXPECT_LT((weights.rowwise().sum().array() - 1).abs().maxCoeff(), 1e-12);
  for (const int i : soft.vertices) EXPECT_NEAR(weights(i, 1), 0.3, 0.05);
}

TEST(Soft, StrengthsThatMakeNoSenseAreNamed) {
  const Mesh mesh = meshes::cube();
  const auto message = [&](const Constraints& constraints) -> std::string {
    try {
      const Deformer deformer(mesh, constraints);
    } catch (const DeformError& error) {
      return error.what();
    }
    return "nothing was thrown";
  };
  EXPECT_EQ(message({{0, 1}, {}, {0, 1}, {0.5, 0}}),
            "the strength of handle 1 is 0; it must be above 0 and at most 1");
  EXPECT_EQ(message({{0, 1}, {}, {0, 1}, {1.5, 1}}),
            "the strength of handle 0 is 1.5; it must be above 0 and at most 1");
  EXPECT_EQ(message({{0, 1}, {}, {0, 1}, {1}}), "handle 1 has no strength");
  EXPECT_EQ(message({{0, 1}, {}, {0, 1}, {0.5, 0.5}}), "nothing was thrown");
}

}  // namespace
}  // namespace flexkey
