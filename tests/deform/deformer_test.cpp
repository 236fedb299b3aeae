#include "flexkey/deform/deformer.h"

#include <gtest/gtest.h>

#include <numeric>

#include "support/meshes.h"

namespace flexkey {
namespace {

/// A bar that is held at its low end and moved at its high end.
struct Bar {
  Mesh mesh = meshes::bumpy(meshes::bar(10, 2, 2), 0.1);
  Constraints constraints{ends(), {}};
  double diagonal = bounds_of(mesh.positions).diagonal();

  std::vector<int> ends() const {
    std::vector<int> ends = low_end();
    const std::vector<int> high = high_end();
    ends.insert(ends.end(), high.begin(), high.end());
    return ends;
  }
  std::vector<int> low_end() const { return meshes::between(mesh, 0, -1, 0.5); }
  std::vector<int> high_end() const { return meshes::between(mesh, 0, 9.5, 11); }

  Positions rest_targets() const { return mesh.positions(constraints.handles, Eigen::all); }
  /// The high end turned about the middle of the bar and moved by a tenth of its length.
  Positions targets(double degrees) const {
    Positions targets = rest_targets();
    const auto count = static_cast<Eigen::Index>(high_end().size());
    const Positions high = targets.bottomRows(count).rowwise() - Eigen::RowVector3d(5, 1, 1);
    targets.bottomRows(count) = meshes::moved(high, meshes::turn(degrees, {0.3, 1, 0.5}), {5, 1, 2});
    return targets;
  }
  Deformer deformer(const DeformOptions& options = {}) const { return Deformer(mesh, constraints, options); }
};

double largest_distance(const Positions& a, const Positions& b) {
  return (a - b).rowwise().norm().maxCoeff();
}

TEST(Deformer, AFirstFrameAtRestIsTheRestBitForBit) {
  const Bar bar;
  for (const bool fixed_count : {false, true}) {
    const Deformer deformer =
        bar.deformer({.predict = false, .accelerate = false, .fixed_count = fixed_count});
    Pose pose = deformer.rest_pose();
    for (const double lambda : {0.5, 0.0, 1.0}) {
      EXPECT_EQ(deformer.solve(bar.rest_targets(), lambda, pose).solves, 0);
      EXPECT_EQ(pose.positions, bar.mesh.positions);
    }
  }
}

TEST(Deformer, HandlesAreMetToTheLastBit) {
  const Bar bar;
  for (const System system : {System::least_squares, System::direct}) {
    const Deformer deformer = bar.deformer({.system = system});
    Pose pose = deformer.rest_pose();
    for (const double degrees : {10.1, 20.2, 30.3}) {
      const Positions targets = bar.targets(degrees);
      deformer.solve(targets, 0.3, pose);
      EXPECT_EQ(Positions(pose.positions(bar.constraints.handles, Eigen::all)), targets);
    }
  }
}

TEST(Deformer, AnUnchangedConvergedFrameRepeatsBitForBit) {
  const Bar bar;
  const Deformer deformer = bar.deformer({.iterations = 500});
  Pose pose = deformer.rest_pose();
  EXPECT_TRUE(deformer.solve(bar.targets(20), 0.5, pose).converged);
  const Positions before = pose.positions;
  const SolveReport again = deformer.solve(bar.targets(20), 0.5, pose);
  EXPECT_EQ(again.solves, 0);
  EXPECT_TRUE(again.converged);
  EXPECT_EQ(pose.positions, before);
  EXPECT_GT(deformer.solve(bar.targets(20), 0.6, pose).solves, 0);
  EXPECT_GT(deformer.solve(bar.targets(21), 0.6, pose).solves, 0);
}

TEST(Deformer, AFrameThatDidNotConvergeGoesOn) {
  const Bar bar;
  const Deformer deformer = bar.deformer({.iterations = 4, .tolerance = 1e-9});
  Pose pose = deformer.rest_pose();
  const SolveReport first = deformer.solve(bar.targets(20), 0.5, pose);
  EXPECT_FALSE(first.converged);
  EXPECT_EQ(first.solves, 4);
  EXPECT_LT(deformer.solve(bar.targets(20), 0.5, pose).step, first.step);
}

TEST(Deformer, AFixedCountSpendsItExactlyAndClaimsNothing) {
  const Bar bar;
  const Deformer deformer =
      bar.deformer({.iterations = 2, .predict = false, .accelerate = false, .fixed_count = true});
  Pose pose = deformer.rest_pose();
  const SolveReport first = deformer.solve(bar.targets(10), 0.5, pose);
  EXPECT_EQ(first.solves, 3);  // the naive Laplacian start, then two
  EXPECT_FALSE(first.converged);
  EXPECT_EQ(deformer.solve(bar.targets(10), 0.5, pose).solves, 2);
  EXPECT_EQ(deformer.solve(bar.targets(20), 0.5, pose).solves, 2);
}

TEST(Deformer, AToleranceReachesTheConvergedShape) {
  const Bar bar{.mesh = meshes::bumpy(meshes::bar(10, 1, 1), 0.1)};
  for (const System system : {System::least_squares, System::direct}) {
    for (const double lambda : {0.0, 0.8}) {
      const Deformer deformer = bar.deformer({.system = system, .iterations = 400, .tolerance = 1e-5});
      const Deformer plain = bar.deformer(
          {.system = system, .iterations = 400, .predict = false, .accelerate = false, .fixed_count = true});
      Pose found = deformer.rest_pose(), reference = plain.rest_pose();
      EXPECT_TRUE(deformer.solve(bar.targets(40), lambda, found).converged);
      EXPECT_LT(plain.solve(bar.targets(40), lambda, reference).step, 1e-6);
      EXPECT_LT(largest_distance(found.positions, reference.positions), 1e-4 * bar.diagonal);
    }
  }
}

TEST(Deformer, ThePoseIsFittedToItsPositions) {
  const Bar bar;
  const Deformer deformer = bar.deformer({.iterations = 3});
  Pose pose = deformer.rest_pose();
  deformer.solve(bar.targets(30), 0.5, pose);
  const Pose refitted = deformer.pose_at(pose.positions);
  for (int v = 0; v < bar.mesh.vertex_count(); ++v) {
    EXPECT_LT((refitted.rotations[v] - pose.rotations[v]).norm(), 1e-12);
  }
  EXPECT_LT((refitted.scales - pose.scales).norm(), 1e-12);
}

TEST(Deformer, ARegionGivesWhatItsOutsideAsAnAnchorGives) {
  const Bar bar;
  const std::vector<int> region = meshes::between(bar.mesh, 0, 2.5, 7.5);
  const std::vector<int> handles = meshes::between(bar.mesh, 0, 4.7, 5.3);
  std::vector<bool> inside(bar.mesh.vertex_count(), false);
  for (const int v : region) inside[v] = true;
  std::vector<int> with_anchor = handles;
  for (int v = 0; v < bar.mesh.vertex_count(); ++v) {
    if (!inside[v]) with_anchor.push_back(v);
  }
  Positions targets = bar.mesh.positions(with_anchor, Eigen::all);
  const auto count = static_cast<Eigen::Index>(handles.size());
  targets.topRows(count).rowwise() += Eigen::RowVector3d(0.3, 0.8, -0.2);

  for (const System system : {System::least_squares, System::direct}) {
    const DeformOptions options{.system = system, .iterations = 60};
    const Deformer roi(bar.mesh, {handles, region}, options), whole(bar.mesh, {with_anchor, {}}, options);
    Pose in_roi = roi.rest_pose(), in_whole = whole.rest_pose();
    roi.solve(targets.topRows(count), 0.4, in_roi);
    whole.solve(targets, 0.4, in_whole);
    EXPECT_GT(largest_distance(in_roi.positions, bar.mesh.positions), 0.5);
    EXPECT_LT(largest_distance(in_roi.positions, in_whole.positions), 1e-9 * bar.diagonal);
    for (const int v : with_anchor) {
      if (inside[v]) continue;
      EXPECT_EQ(in_roi.positions.row(v), bar.mesh.positions.row(v));
    }
  }
}

TEST(Deformer, TwoComponentsMoveApart) {
  const Bar bar;
  Mesh other = bar.mesh;
  other.positions.col(2).array() += 20;
  const Mesh both = meshes::joined(bar.mesh, other);
  Constraints constraints = bar.constraints;
  constraints.handles.push_back(bar.mesh.vertex_count());  // one vertex holds the second bar
  const Deformer deformer(both, constraints);
  Positions targets(static_cast<Eigen::Index>(constraints.handles.size()), 3);
  targets << bar.targets(30), both.positions.row(bar.mesh.vertex_count()) + Eigen::RowVector3d(1, 2, 3);
  Pose pose = deformer.rest_pose();
  deformer.solve(targets, 0.5, pose);
  const Positions carried = other.positions.rowwise() + Eigen::RowVector3d(1, 2, 3);
  EXPECT_LT(largest_distance(pose.positions.bottomRows(bar.mesh.vertex_count()), carried),
            1e-9 * bar.diagonal);
}

TEST(Deformer, WithEverythingHeldThereIsNothingToSolve) {
  const Mesh mesh = meshes::cube();
  std::vector<int> all(8);
  std::iota(all.begin(), all.end(), 0);
  const Deformer deformer(mesh, {all, {}});
  Pose pose = deformer.rest_pose();
  const Positions targets = 2 * mesh.positions;
  const SolveReport report = deformer.solve(targets, 0.5, pose);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.solves, 0);
  EXPECT_EQ(pose.positions, targets);
}

TEST(Deformer, HandlesMayAllMeetInOnePoint) {
  const Bar bar;
  for (const LocalScale kind : {LocalScale::uniform, LocalScale::axis, LocalScale::none}) {
    const Deformer deformer = bar.deformer({.local_scale = kind});
    Pose pose = deformer.rest_pose();
    const Positions point = Positions::Constant(bar.rest_targets().rows(), 3, 0.25);
    for (const double lambda : {0.0, 1.0}) {
      deformer.solve(point, lambda, pose);
      EXPECT_TRUE(pose.positions.allFinite());
    }
    deformer.solve(bar.targets(10), 0.5, pose);
    EXPECT_TRUE(pose.positions.allFinite());
  }
}

TEST(Deformer, AnUnreferencedVertexStaysAtRestOrFollowsItsHandle) {
  Mesh mesh = meshes::cube();
  mesh.positions.conservativeResize(10, 3);
  mesh.positions.bottomRows(2) << 7, 7, 7, 9, 9, 9;
  const Deformer deformer(mesh, {{0, 9}, {}});
  Pose pose = deformer.rest_pose();
  Positions targets(2, 3);
  targets << 1, 1, 1, 2, 2, 2;
  deformer.solve(targets, 0.5, pose);
  EXPECT_EQ(pose.positions.row(8), Eigen::RowVector3d(7, 7, 7));
  EXPECT_EQ(pose.positions.row(9), Eigen::RowVector3d(2, 2, 2));
  EXPECT_LT((pose.positions.row(7) - mesh.positions.row(7) - Eigen::RowVector3d(1, 1, 1)).norm(), 1e-9);
}

TEST(Deformer, RepeatedCornersAndNonManifoldFacesSolve) {
  Mesh mesh = meshes::grid(4, 4);
  mesh.positions.conservativeResize(26, 3);
  mesh.positions.row(25) << 2, 2, 3;
  mesh.add_face(std::array{6, 7, 25});  // a fin on an inner edge
  mesh.add_face(std::array{6, 7, 25});
  mesh.add_face(std::array{12, 12, 13});
  mesh.add_face(std::array{12, 13, 12, 13});
  const Deformer deformer(mesh, {{0, 24}, {}});
  Pose pose = deformer.rest_pose();
  Positions targets(2, 3);
  targets << 0, 0, 1, 4, 5, 0;
  deformer.solve(targets, 0.5, pose);
  EXPECT_TRUE(pose.positions.allFinite());
  EXPECT_GT((pose.positions.row(25) - mesh.positions.row(25)).norm(), 0.01);
}

TEST(Deformer, SliversDoNotRunAway) {
  Bar bar;
  Mesh& mesh = bar.mesh;
  for (int f = 0; f < mesh.face_count(); f += 30) {  // every thirtieth quad loses an edge or a corner
    const auto face = mesh.face(f);
    const double share = f % 60 == 0 ? 0 : 0.5;
    mesh.positions.row(face[0]) =
        (1 - share) * mesh.positions.row(face[1]) + share * mesh.positions.row(face[2]);
  }
  for (const System system : {System::least_squares, System::direct}) {
    for (const double lambda : {0.0, 0.5, 1.0}) {
      const Deformer deformer = bar.deformer({.system = system, .iterations = 200});
      Pose pose = deformer.rest_pose();
      EXPECT_TRUE(deformer.solve(bar.targets(20), lambda, pose).converged);
      EXPECT_LT(largest_distance(pose.positions, mesh.positions), 0.5 * bar.diagonal);
    }
  }
}

}  // namespace
}  // namespace flexkey
