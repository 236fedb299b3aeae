#include "flexkey/deform/prediction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "flexkey/deform/deformer.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

/// A long bar along z, held at its low end (handle 0) and led at its high end (handle 1).
struct LongBar {
  Mesh mesh;
  int length;
  Constraints constraints;
  std::size_t low_count = 0;

  LongBar(int width, int sections) : mesh(meshes::bar(width, width, sections)), length(sections) {
    for (const double z : {0.0, static_cast<double>(sections)})
      for (const int v : meshes::between(mesh, 2, z, z)) {
        constraints.handles.push_back(v);
        constraints.owner.push_back(z == 0 ? 0 : 1);
      }
    low_count = static_cast<std::size_t>(std::count(constraints.owner.begin(), constraints.owner.end(), 0));
  }

  Vec3 middle() const { return bounds_of(mesh.positions).min / 2 + bounds_of(mesh.positions).max / 2; }

  /// The high end turned about the bar's axis.
  Targets twisted(double degrees, double by_degrees) const {
    Positions where = mesh.positions(constraints.handles, Eigen::all);
    const auto high = where.rows() - static_cast<Eigen::Index>(low_count);
    const Eigen::RowVector3d centre(middle().x(), middle().y(), 0);
    const Positions arms = where.bottomRows(high).rowwise() - centre;
    where.bottomRows(high) = meshes::moved(arms, meshes::turn(degrees, Vec3::UnitZ()), centre.transpose());
    Positions turns = Positions::Zero(2, 3);
    turns(1, 2) = by_degrees * std::numbers::pi / 180;
    return {where, turns};
  }

  /// The turn of each section z = 0 .. length about the axis, degrees, continuous along the bar.
  std::vector<double> section_angles(const Positions& positions) const {
    std::vector<double> angles;
    for (int z = 0; z <= length; ++z) {
      double sine = 0, cosine = 0;
      for (const int v : meshes::between(mesh, 2, z, z)) {
        const Vec3 a = mesh.positions.row(v).transpose() - middle(),
                   b = positions.row(v).transpose() - middle();
        sine += a.x() * b.y() - a.y() * b.x();
        cosine += a.x() * b.x() + a.y() * b.y();
      }
      double angle = std::atan2(sine, cosine) * 180 / std::numbers::pi;
      while (!angles.empty() && angle < angles.back() - 180) angle += 360;
      while (!angles.empty() && angle > angles.back() + 180) angle -= 360;
      angles.push_back(angle);
    }
    return angles;
  }
};

TEST(Prediction, ARigidMotionOfAllHandlesIsReachedInOneSolve) {
  const LongBar bar(2, 8);
  const Eigen::Matrix3d turn = meshes::turn(75, {1, 2, 0.5});
  const Vec3 shift(3, -1, 2);
  const Positions moved = meshes::moved(bar.mesh.positions, turn, shift);
  const Eigen::AngleAxisd angle_axis(turn);
  Positions turns(2, 3);
  turns.rowwise() = (angle_axis.angle() * angle_axis.axis()).transpose();
  for (const System system : {System::least_squares, System::direct})
    for (const double lambda : {0.0, 0.5, 1.0}) {
      const Deformer deformer(bar.mesh, bar.constraints, {.system = system, .iterations = 1});
      Pose pose = deformer.rest_pose();
      deformer.solve({moved(bar.constraints.handles, Eigen::all), turns}, lambda, pose);
      EXPECT_LT((pose.positions - moved).rowwise().norm().maxCoeff(), 1e-9);
    }
}

TEST(Prediction, TurnsOfAnyLengthAreRotationsAboutTheirAxis) {
  const Vec3 axis = Vec3(1, -2, 0.5).normalized();
  const Eigen::Matrix3d before = Eigen::AngleAxisd(0.7, Vec3(0, 0.6, 0.8)).toRotationMatrix();
  for (const double angle : {0.0, 1e-9, 1e-4, 0.05, 0.0999, 0.1001, 1.0, 3.2, 20.0}) {
    const Transforms turned =
        turned_further({{before}, Positions::Ones(1, 3)}, Positions(angle * axis.transpose()));
    const Eigen::Matrix3d expected = Eigen::AngleAxisd(angle, axis) * before;
    EXPECT_LT((turned.rotations[0] - expected).norm(), 2e-15) << angle;
  }
}

TEST(Prediction, TheWeightsOfAllHandlesSumToOne) {
  const LongBar bar(2, 8);
  const Cells cells = build_cells(bar.mesh, Weights::clamped);
  std::vector<bool> is_free(static_cast<std::size_t>(bar.mesh.vertex_count()), true);
  std::vector<int> owner(is_free.size(), -1);
  for (std::size_t k = 0; k < bar.constraints.handles.size(); ++k) {
    is_free[bar.constraints.handles[k]] = false;
    owner[bar.constraints.handles[k]] = bar.constraints.owner[k];
  }
  const Patch patch = make_patch(cells, bar.mesh.positions, is_free, System::least_squares);
  const Eigen::MatrixXd weights = harmonic_weights(cells, patch, owner, 2);
  EXPECT_LT((weights.rowwise().sum().array() - 1).abs().maxCoeff(), 1e-12);
  EXPECT_GE(weights.minCoeff(), -1e-12);
}

/// The largest distance of the section angles from linear, degrees.
double unevenness(const LongBar& bar, const Positions& positions, double degrees) {
  const std::vector<double> angles = bar.section_angles(positions);
  double most = 0;
  for (int z = 0; z <= bar.length; ++z)
    most = std::max(most, std::abs(angles[static_cast<std::size_t>(z)] - degrees * z / bar.length));
  return most;
}

// The ends are clamped, so that the twist is a little less there than in the middle: in eq 7 more than in
// eq 5. At λ = 0.5 the last tenth of the way takes up to some 200 solves a frame; where a cap cuts them
// short, rounding decides where the bar goes.
TEST(Prediction, ALongBarFollowsTwoTurnsAndComesBack) {
  const LongBar bar(3, 60);
  for (const System system : {System::least_squares, System::direct})
    for (const double lambda : {0.5, 1.0}) {
      const Deformer deformer(bar.mesh, bar.constraints,
                              {.system = system, .iterations = 300, .tolerance = 1e-5});
      Pose pose = deformer.rest_pose();
      bool slipped = false;
      for (int degrees = 10; degrees <= 720; degrees += 10)
        slipped = deformer.solve(bar.twisted(degrees, 10), lambda, pose).slipped || slipped;
      EXPECT_LT(unevenness(bar, pose.positions, 720), system == System::direct ? 7 : 18) << "λ " << lambda;
      for (int degrees = 710; degrees >= 0; degrees -= 10)
        slipped = deformer.solve(bar.twisted(degrees, -10), lambda, pose).slipped || slipped;
      EXPECT_FALSE(slipped) << "λ " << lambda;
      const double diagonal = bounds_of(bar.mesh.positions).diagonal();
      EXPECT_LT((pose.positions - bar.mesh.positions).rowwise().norm().maxCoeff(), 1e-4 * diagonal)
          << "λ " << lambda;
    }
}

// A closed surface without volume cannot hold a turn over so short a length.
TEST(Prediction, AShortBarIsReportedAsSlippedFromWhereItSlips) {
  const LongBar bar(6, 24);
  for (const double lambda : {0.5, 1.0}) {
    const Deformer deformer(bar.mesh, bar.constraints, {.system = System::direct, .iterations = 100});
    Pose pose = deformer.rest_pose();
    int slipped_at = 0;
    for (int degrees = 10; degrees <= 540; degrees += 10) {
      const bool slipped = deformer.solve(bar.twisted(degrees, 10), lambda, pose).slipped;
      if (degrees <= 150) {
        EXPECT_FALSE(slipped) << "λ " << lambda << " at " << degrees;
      }
      if (slipped && slipped_at == 0) slipped_at = degrees;
    }
    EXPECT_GT(slipped_at, 150) << "λ " << lambda;
  }
}

TEST(Prediction, AClosedLoopOfMotionReturnsToRest) {
  const LongBar bar(3, 12);
  const double diagonal = bounds_of(bar.mesh.positions).diagonal();
  for (const System system : {System::least_squares, System::direct})
    for (const LocalScale scale : {LocalScale::uniform, LocalScale::axis, LocalScale::none})
      for (const double lambda : {0.0, 0.5, 1.0}) {
        const Deformer deformer(
            bar.mesh, bar.constraints,
            {.system = system, .local_scale = scale, .iterations = 500, .tolerance = 1e-5});
        Pose pose = deformer.rest_pose();
        int before = 0;
        for (const int degrees : {15, 30, 45, 60, 40, 20, 0, -20, 0}) {
          deformer.solve(bar.twisted(degrees, degrees - before), lambda, pose);
          before = degrees;
        }
        EXPECT_LT((pose.positions - bar.mesh.positions).rowwise().norm().maxCoeff(), 1e-4 * diagonal)
            << "λ " << lambda;
      }
}

TEST(Prediction, WarmAndColdStartsAgreeForSmallMotions) {
  const LongBar bar(3, 12);
  const double diagonal = bounds_of(bar.mesh.positions).diagonal();
  for (const System system : {System::least_squares, System::direct})
    for (const double lambda : {0.0, 0.5, 1.0}) {
      const Deformer deformer(bar.mesh, bar.constraints,
                              {.system = system, .iterations = 2000, .tolerance = 1e-7});
      Pose warm = deformer.rest_pose(), cold = deformer.rest_pose();
      for (int degrees = 3; degrees <= 12; degrees += 3)
        deformer.solve(bar.twisted(degrees, 3), lambda, warm);
      deformer.solve(bar.twisted(12, 12), lambda, cold);
      EXPECT_LT((warm.positions - cold.positions).rowwise().norm().maxCoeff(), 1e-5 * diagonal)
          << "λ " << lambda;
    }
}

TEST(Prediction, AcceleratedAndPlainAgree) {
  const LongBar bar(2, 8);
  for (const System system : {System::least_squares, System::direct})
    for (const double lambda : {0.0, 0.5}) {
      const DeformOptions fast{.system = system, .iterations = 3000, .tolerance = 1e-9};
      DeformOptions plain = fast;
      plain.predict = plain.accelerate = false;
      const Deformer accelerated(bar.mesh, bar.constraints, fast), slow(bar.mesh, bar.constraints, plain);
      Pose a = accelerated.rest_pose(), b = slow.rest_pose();
      const SolveReport quick = accelerated.solve(bar.twisted(25, 25), lambda, a);
      const SolveReport steady = slow.solve(bar.twisted(25, 25), lambda, b);
      EXPECT_TRUE(quick.converged);
      EXPECT_TRUE(steady.converged);
      EXPECT_LT(quick.solves, steady.solves);
      EXPECT_LT((a.positions - b.positions).rowwise().norm().maxCoeff(), 1e-6);
    }
}

TEST(Prediction, TurnsMustFitTheHandles) {
  const LongBar bar(1, 3);
  const Deformer deformer(bar.mesh, bar.constraints);
  Pose pose = deformer.rest_pose();
  Targets targets = bar.twisted(10, 10);
  targets.turns.conservativeResize(3, 3);
  EXPECT_THROW(deformer.solve(targets, 0.5, pose), DeformError);
}

}  // namespace
}  // namespace flexkey
