#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "flexkey/deform/deformer.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

/// A bar along z, held at its low end, whose high end is led so that the bar bends into an arc.
struct BendingBar {
  Mesh mesh;
  double length;
  Constraints constraints;

  BendingBar(int width, int sections) : mesh(meshes::bar(width, width, sections)), length(sections) {
    for (const double z : {0.0, length})
      for (const int v : meshes::between(mesh, 2, z, z)) {
        constraints.handles.push_back(v);
        constraints.owner.push_back(z == 0 ? 0 : 1);
      }
  }

  double diagonal() const { return bounds_of(mesh.positions).diagonal(); }

  /// On an arc of that many degrees, reached from one of `by_degrees` less.
  Targets bent(double degrees, double by_degrees) const {
    const double angle = degrees * std::numbers::pi / 180, radius = length / angle;
    const Eigen::Matrix3d turn = meshes::turn(degrees, Vec3::UnitX());
    const Vec3 tip(0, -radius * (1 - std::cos(angle)), radius * std::sin(angle));
    Positions where = mesh.positions(constraints.handles, Eigen::all);
    for (Eigen::Index k = 0; k < where.rows(); ++k)
      if (constraints.owner[static_cast<std::size_t>(k)] == 1)
        where.row(k) = (turn * (where.row(k).transpose() - length * Vec3::UnitZ()) + tip).transpose();
    Positions turns = Positions::Zero(2, 3);
    turns(1, 0) = by_degrees * std::numbers::pi / 180;
    return {where, turns};
  }
};

/// How far the pose still goes when it is carried on to 1e-9, a share of the diagonal.
double distance_left(const BendingBar& bar, const DeformOptions& options, const Targets& targets,
                     double lambda, Pose pose) {
  DeformOptions on = options;
  on.predict = false;
  on.tolerance = 1e-9;
  on.iterations = 1000;
  const Deformer deformer(bar.mesh, bar.constraints, on);
  const Positions before = pose.positions;
  pose.converged = false;
  pose.course = {};
  EXPECT_TRUE(deformer.solve(Targets(targets.positions), lambda, pose).converged);
  return (pose.positions - before).rowwise().norm().maxCoeff() / bar.diagonal();
}

TEST(Honesty, AConvergedFrameOfABendIsWithinTwiceTheTolerance) {
  const BendingBar bar(4, 16);
  for (const System system : {System::least_squares, System::direct})
    for (const double lambda : {0.0, 0.5}) {
      const DeformOptions options{.system = system};
      const Deformer deformer(bar.mesh, bar.constraints, options);
      Pose pose = deformer.rest_pose();
      for (int frame = 1; frame <= 12; ++frame) {
        const Targets targets = bar.bent(7.5 * frame, 7.5);
        EXPECT_TRUE(deformer.solve(targets, lambda, pose).converged);
        EXPECT_LT(distance_left(bar, options, targets, lambda, pose), 2 * options.tolerance)
            << "λ " << lambda << ", frame " << frame;
      }
    }
}

TEST(Honesty, TheSixteenthFrameFillsTheWindow) {
  const BendingBar bar(2, 20);
  const Deformer deformer(bar.mesh, bar.constraints, {.system = System::direct});
  Pose pose = deformer.rest_pose();
  std::vector<int> solves;
  for (int frame = 1; frame <= 18; ++frame)
    solves.push_back(deformer.solve(bar.bent(2.0 * frame, 2), 0.5, pose).solves);
  EXPECT_GE(solves[15], 10);
  EXPECT_LT(solves[14], 10);
  EXPECT_LT(solves[17], 10);
}

}  // namespace
}  // namespace flexkey
