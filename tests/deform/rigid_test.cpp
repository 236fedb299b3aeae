#include "flexkey/deform/rigid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "flexkey/deform/deformer.h"
#include "flexkey/deform/rigid_system.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

/// A bar along z, held at its low end (handle 0) and led at its high end (handle 1).
struct Bar {
  Mesh mesh = meshes::bumpy(meshes::bar(3, 3, 12), 0.1);
  Constraints constraints;
  Eigen::Index high_count = 0;

  Bar() {
    constraints.handles = meshes::between(mesh, 2, -1, 0.5);
    constraints.owner.assign(constraints.handles.size(), 0);
    const std::vector<int> high = meshes::between(mesh, 2, 11.5, 13);
    high_count = static_cast<Eigen::Index>(high.size());
    constraints.handles.insert(constraints.handles.end(), high.begin(), high.end());
    constraints.owner.resize(constraints.handles.size(), 1);
  }

  /// The high end bent aside.
  Targets bent(double degrees) const {
    Positions targets = mesh.positions(constraints.handles, Eigen::all);
    const Eigen::RowVector3d pivot(1.5, 1.5, 8);
    const Positions arms = targets.bottomRows(high_count).rowwise() - pivot;
    const Vec3 axis = Vec3(1, 0.3, 0.8).normalized();
    targets.bottomRows(high_count) =
        meshes::moved(arms, meshes::turn(degrees, axis), pivot.transpose() + Vec3(0, 1, 0));
    Positions turns = Positions::Zero(2, 3);
    turns.row(1) = degrees * std::numbers::pi / 180 * axis.transpose();
    return {targets, turns};
  }
};

double largest(const Positions& difference) {
  return difference.rowwise().norm().maxCoeff();
}

Positions centred(const Positions& points) {
  return points.rowwise() - points.colwise().mean();
}

/// How far a region is from being its rest shape moved: det +1 rotations only.
double distortion(const Mesh& rest, const Positions& positions, const std::vector<int>& region) {
  const Positions a = centred(rest.positions(region, Eigen::all)), b = centred(positions(region, Eigen::all));
  const Eigen::Matrix3d Q = Eigen::umeyama(a.transpose(), b.transpose(), false).topLeftCorner<3, 3>();
  return largest(b - a * Q.transpose());
}

std::vector<std::vector<int>> two_regions(const Mesh& mesh) {
  return {meshes::between(mesh, 2, 2.5, 4.5), meshes::between(mesh, 2, 6.5, 8.5)};
}

TEST(Rigid, RegionsAreExactlyRigidInEveryAnswer) {
  Bar bar;
  const std::vector<std::vector<int>> regions = two_regions(bar.mesh);
  bar.constraints.rigid = regions;
  for (const System system : {System::least_squares, System::direct})
    for (const double lambda : {0.0, 0.5, 1.0})
      for (const int iterations : {1, 3, 200}) {
        const Deformer deformer(bar.mesh, bar.constraints, {.system = system, .iterations = iterations});
        Pose pose = deformer.rest_pose();
        deformer.solve(bar.bent(25), lambda, pose);
        deformer.solve(bar.bent(50), lambda, pose);
        for (const std::vector<int>& region : regions) {
          EXPECT_LT(distortion(bar.mesh, pose.positions, region), 1e-12);
          EXPECT_GT(largest(pose.positions(region, Eigen::all) - bar.mesh.positions(region, Eigen::all)),
                    0.1);
        }
      }
}

TEST(Rigid, WithoutTheRegionTheSameVerticesBend) {
  const Bar bar;
  const Deformer deformer(bar.mesh, bar.constraints, {.iterations = 200});
  Pose pose = deformer.rest_pose();
  deformer.solve(bar.bent(50), 0.5, pose);
  EXPECT_GT(distortion(bar.mesh, pose.positions, two_regions(bar.mesh)[1]), 0.05);
}

TEST(Rigid, ARigidMotionOfAllHandlesIsReachedInOneSolve) {
  Bar bar;
  bar.constraints.rigid = two_regions(bar.mesh);
  const Eigen::AngleAxisd turn(1.2, Vec3(1, 2, 0.5).normalized());
  const Positions moved = meshes::moved(bar.mesh.positions, turn.toRotationMatrix(), {3, -1, 2});
  Positions turns(2, 3);
  turns.rowwise() = (turn.angle() * turn.axis()).transpose();
  for (const System system : {System::least_squares, System::direct})
    for (const double lambda : {0.0, 0.5, 1.0}) {
      const Deformer deformer(bar.mesh, bar.constraints, {.system = system, .iterations = 1});
      Pose pose = deformer.rest_pose();
      deformer.solve({moved(bar.constraints.handles, Eigen::all), turns}, lambda, pose);
      EXPECT_LT(largest(pose.positions - moved), 1e-9);
    }
}

// Every edge that leaves the cap runs along the bar and tells nothing of a turn about it; the moments do.
TEST(Rigid, ACapThatNothingElseHoldsFollowsTheTurnOfTheBar) {
  const Mesh mesh = meshes::bar(3, 3, 9);
  Constraints constraints{meshes::between(mesh, 2, 0, 0)};
  constraints.rigid = {meshes::between(mesh, 2, 5, 9)};
  for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(1, 2, 3)}) {
    const Positions moved = meshes::moved(mesh.positions, meshes::turn(40, axis), {0, 1, 0});
    for (const System system : {System::least_squares, System::direct}) {
      const Deformer deformer(mesh, constraints,
                              {.system = system, .iterations = 2000, .tolerance = 1e-9, .predict = false});
      Pose pose = deformer.rest_pose();
      EXPECT_TRUE(deformer.solve(moved(constraints.handles, Eigen::all), 0.5, pose).converged);
      EXPECT_LT(largest(pose.positions - moved), 1e-6);
    }
  }
}

TEST(Rigid, ARegionOfOneVertexOnlyLosesItsOwnScale) {
  const Bar bar;
  Bar pinned;
  pinned.constraints.rigid = {{meshes::between(bar.mesh, 2, 5.5, 6.5).front()}};
  const DeformOptions options{.local_scale = LocalScale::none, .iterations = 2000, .tolerance = 1e-10};
  const Deformer plain(bar.mesh, bar.constraints, options), rigid(bar.mesh, pinned.constraints, options);
  Pose a = plain.rest_pose(), b = rigid.rest_pose();
  EXPECT_TRUE(plain.solve(bar.bent(30), 0.5, a).converged);
  EXPECT_TRUE(rigid.solve(bar.bent(30), 0.5, b).converged);
  EXPECT_LT(largest(a.positions - b.positions), 1e-7);
}

TEST(Rigid, ARegionOnALineKeepsItsLengthAndTurnsWithItsNeighbours) {
  Bar bar;
  bar.mesh = meshes::bar(3, 3, 12);  // straight edges
  std::vector<int> line;
  for (const int v : meshes::between(bar.mesh, 2, 4, 8)) {
    if (bar.mesh.positions(v, 0) == 0 && bar.mesh.positions(v, 1) == 0) line.push_back(v);
  }
  ASSERT_EQ(line.size(), 5u);
  bar.constraints.rigid = {line};
  for (const System system : {System::least_squares, System::direct}) {
    const Deformer deformer(bar.mesh, bar.constraints, {.system = system, .iterations = 500});
    Pose pose = deformer.rest_pose();
    EXPECT_TRUE(deformer.solve(bar.bent(40), 0.5, pose).converged);
    EXPECT_LT(distortion(bar.mesh, pose.positions, line), 1e-12);
    const Eigen::Matrix3d Q = pose.rotations[line.front()];
    const Positions turned = centred(bar.mesh.positions(line, Eigen::all)) * Q.transpose();
    EXPECT_LT(largest(centred(pose.positions(line, Eigen::all)) - turned), 1e-3);
  }
}

TEST(Rigid, TheConvergedAnswerDoesNotDependOnTheWay) {
  Bar bar;
  bar.constraints.rigid = two_regions(bar.mesh);
  for (const System system : {System::least_squares, System::direct}) {
    const DeformOptions fast{.system = system, .iterations = 5000, .tolerance = 1e-9};
    DeformOptions steady = fast;
    steady.predict = steady.accelerate = false;
    const Deformer accelerated(bar.mesh, bar.constraints, fast), plain(bar.mesh, bar.constraints, steady);
    Pose a = accelerated.rest_pose(), b = plain.rest_pose();
    EXPECT_TRUE(accelerated.solve(bar.bent(30), 0.5, a).converged);
    EXPECT_TRUE(plain.solve(bar.bent(30), 0.5, b).converged);
    EXPECT_LT(largest(a.positions - b.positions), 1e-6);
  }
}

TEST(Rigid, ARegionJoinsWhatNothingElseHolds) {
  Mesh far = meshes::cube();
  far.positions.col(2).array() += 14;
  const Bar bar;
  const Mesh both = meshes::joined(bar.mesh, far);
  Constraints constraints = bar.constraints;
  std::vector<int> region = meshes::between(bar.mesh, 2, 6.5, 8.5);
  for (int k = 0; k < 8; ++k) region.push_back(bar.mesh.vertex_count() + k);
  constraints.rigid = {region};
  const Deformer deformer(both, constraints, {.iterations = 100});
  Pose pose = deformer.rest_pose();
  deformer.solve(bar.bent(30), 0.5, pose);
  EXPECT_LT(distortion(both, pose.positions, region), 1e-12);
}

// Against the energy itself: no small turn or shift of the regions with the rest relaxed lowers it.
TEST(Rigid, TheStepIsTheLeastEnergyOverEverythingThatTheRegionsCanDo) {
  const int free = 9;
  const Eigen::MatrixXd noise = Eigen::MatrixXd::Random(free, free);
  const Eigen::MatrixXd N = noise * noise.transpose() + Eigen::MatrixXd::Identity(free, free);
  const Positions f = 0.3 * Positions::Random(free, 3);
  std::vector<RigidRegion> regions = {{{1, 2, 3, 4}, Positions::Random(4, 3)},
                                      {{6, 7, 8}, Positions::Random(3, 3)}};
  for (RigidRegion& region : regions) region.arms = centred(region.arms);
  Transforms start;
  start.rotations.assign(free, Eigen::Matrix3d::Identity());
  start.rotations[1] = meshes::turn(30, {1, 0, 1});
  start.rotations[6] = meshes::turn(-50, {0, 1, 1});
  const Positions x = RigidSystem(N.sparseView(), regions).step(f, start);
  const auto energy = [&](const Positions& at) {
    return 0.5 * (at.transpose() * N * at).trace() - (f.transpose() * at).trace();
  };
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const auto& [vertices, arms] = regions[r];
    const Positions where = x(vertices, Eigen::all) + arms * rotation_of(regions[r], start).transpose();
    EXPECT_LT(largest(centred(where) - arms * Eigen::umeyama(arms.transpose(), where.transpose(), false)
                                                  .topLeftCorner<3, 3>()
                                                  .transpose()),
              1e-12);
    for (int axis = 0; axis < 3; ++axis)
      for (const double angle : {-1e-3, 1e-3}) {
        Positions turned = x;
        const Positions arm = centred(where);
        turned(vertices, Eigen::all) +=
            arm * (meshes::turn(angle * 57.3, Vec3::Unit(axis)).transpose() - Eigen::Matrix3d::Identity());
        EXPECT_GT(energy(turned), energy(x));
        Positions shifted = x;
        shifted(vertices, axis).array() += angle;
        EXPECT_GT(energy(shifted), energy(x));
      }
  }
  for (const int v : {0, 5})
    for (const double by : {-1e-3, 1e-3}) {
      Positions shifted = x;
      shifted(v, 1) += by;
      EXPECT_GT(energy(shifted), energy(x));
    }
}

TEST(Rigid, RegionsThatDoNotFitAreNamed) {
  const Mesh mesh = meshes::bar(3, 1, 1);
  const auto message = [&](const Constraints& constraints) -> std::string {
    try {
      const Deformer deformer(mesh, constraints);
    } catch (const DeformError& error) {
      return error.what();
    }
    return "nothing was thrown";
  };
  Constraints constraints{{0, 1}};
  constraints.rigid = {{1, 2, 3}};
  EXPECT_EQ(message(constraints), "vertex 1 is in rigid region 0 and in a handle");
  constraints.rigid = {{4, 5}, {5, 6}};
  EXPECT_EQ(message(constraints), "vertex 5 is in rigid regions 0 and 1");
  constraints.rigid = {{4, 4}};
  EXPECT_EQ(message(constraints), "vertex 4 is given twice in rigid region 0");
  constraints.rigid = {{16}};
  EXPECT_EQ(message(constraints), "rigid region vertex 16 is not one of the mesh's 16 vertices");
  constraints.region = {0, 1, 2, 3};
  constraints.rigid = {{3, 7}};
  EXPECT_EQ(message(constraints), "vertex 7 of rigid region 0 lies outside the region of interest");
}

}  // namespace
}  // namespace flexkey
