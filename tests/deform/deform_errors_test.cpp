#include <gmock/gmock.h>

#include <functional>
#include <limits>

#include "flexkey/deform/deformer.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

using testing::HasSubstr;

std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const DeformError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

std::string setup_message(const Mesh& mesh, const Constraints& constraints,
                          const DeformOptions& options = {}) {
  return message_of([&] { const Deformer deformer(mesh, constraints, options); });
}

TEST(DeformErrors, AComponentThatNothingHoldsIsNamed) {
  Mesh far = meshes::sphere(1);
  far.positions.col(0).array() += 10;
  const Mesh mesh = meshes::joined(meshes::cube(), far);
  EXPECT_EQ(setup_message(mesh, {{0, 1}, {}}),
            "the component of 18 vertices at vertex 8 touches no handle or anchor");
  EXPECT_EQ(setup_message(mesh, {}), "the component of 8 vertices at vertex 0 touches no handle or anchor");
  EXPECT_EQ(setup_message(mesh, {{0, 20}, {}}), "nothing was thrown");
}

TEST(DeformErrors, AComponentWithoutAreaIsNamed) {
  Mesh mesh = meshes::joined(meshes::cube(), meshes::grid(3, 1));
  mesh.positions.bottomRows(8).col(1).setZero();
  EXPECT_EQ(setup_message(mesh, {{0, 8}, {}}), "the component of 8 vertices at vertex 8 has no area");
  Mesh point = meshes::cube();
  point.positions.setConstant(3);
  EXPECT_EQ(setup_message(point, {{0}, {}}), "the component of 8 vertices at vertex 0 has no area");
}

TEST(DeformErrors, ConstraintsThatDoNotFitTheMesh) {
  const Mesh mesh = meshes::cube();
  EXPECT_EQ(setup_message(mesh, {{8}, {}}), "handle vertex 8 is not one of the mesh's 8 vertices");
  EXPECT_EQ(setup_message(mesh, {{-1}, {}}), "handle vertex -1 is not one of the mesh's 8 vertices");
  EXPECT_EQ(setup_message(mesh, {{0}, {0, 9}}), "region vertex 9 is not one of the mesh's 8 vertices");
  EXPECT_EQ(setup_message(mesh, {{3, 1, 3}, {}}), "handle vertex 3 is given twice");
  EXPECT_EQ(setup_message(mesh, {{5}, {1, 2}}), "handle vertex 5 lies outside the region of interest");
}

TEST(DeformErrors, ABrokenMesh) {
  Mesh mesh = meshes::cube();
  mesh.positions(4, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(setup_message(mesh, {{0}, {}}), "vertex 4 of the mesh is not at a finite position");
  Mesh unknown_corner = meshes::cube();
  unknown_corner.corners[5] = 99;
  EXPECT_EQ(setup_message(unknown_corner, {{0}, {}}), "face 1 names vertex 99 of a mesh of 8 vertices");
}

TEST(DeformErrors, APositionTooLargeToSquare) {
  Mesh mesh = meshes::cube();
  mesh.positions *= 1e200;
  EXPECT_NE(setup_message(mesh, {{0}, {}}), "nothing was thrown");
}

TEST(DeformErrors, OptionsOutOfRange) {
  const Mesh mesh = meshes::cube();
  EXPECT_EQ(setup_message(mesh, {{0}, {}}, {.iterations = 0}),
            "iterations is 0; it must be from 1 to 1000000");
  EXPECT_EQ(setup_message(mesh, {{0}, {}}, {.tolerance = -1}), "tolerance is -1; it must not be negative");
  EXPECT_THAT(setup_message(mesh, {{0}, {}}, {.tolerance = std::nan("")}), HasSubstr("tolerance is nan"));
  EXPECT_THAT(setup_message(mesh, {{0}, {}}, {.epsilon = -0.1}), HasSubstr("epsilon is -0.1"));
}

TEST(DeformErrors, AreaWeightingOfADirectSystem) {
  EXPECT_EQ(setup_message(meshes::cube(), {{0}, {}}, {.system = System::direct, .area_weighting = true}),
            "area weighting scales the rows of least squares; the direct system has none");
}

TEST(DeformErrors, RimsOfUniformWeights) {
  EXPECT_EQ(
      setup_message(meshes::cube(), {{0}, {}}, {.weights = Weights::uniform, .cell = Cell::spokes_and_rims}),
      "spokes and rims are weighted by their triangles' cotangents; uniform weights have none");
}

TEST(DeformErrors, AFramesValuesThatDoNotFitLeaveThePoseAlone) {
  const Mesh mesh = meshes::bar(3, 1, 1);
  const Deformer deformer(mesh, {{0, 1}, {}});
  Pose pose = deformer.rest_pose();
  const auto frame = [&](const Positions& targets, const Eigen::VectorXd& lambda) {
    return message_of([&] { deformer.solve(targets, lambda, pose); });
  };
  const Eigen::VectorXd half = Eigen::VectorXd::Constant(mesh.vertex_count(), 0.5);
  Positions targets = Positions::Ones(2, 3);
  EXPECT_EQ(frame(Positions::Ones(3, 3), half), "3 targets were given for 2 handle vertices");
  EXPECT_EQ(frame(targets, half.head(4)), "4 values of lambda were given for 16 vertices");
  EXPECT_EQ(frame(targets, 3 * half), "lambda is not between 0 and 1 everywhere");
  EXPECT_EQ(frame(targets, std::nan("") * half), "lambda is not between 0 and 1 everywhere");
  targets(1, 2) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(frame(targets, half), "a handle's target is not a finite position");
  targets(1, 2) = 1e300;
  EXPECT_THAT(frame(targets, half), HasSubstr("the solve left the range of numbers at iteration"));
  EXPECT_EQ(pose.positions, mesh.positions);
  EXPECT_TRUE(pose.converged);
}

TEST(DeformErrors, APoseOfAnotherMesh) {
  const Deformer small(meshes::cube(), {{0}, {}}), large(meshes::bar(3, 1, 1), {{0}, {}});
  Pose pose = large.rest_pose();
  EXPECT_EQ(message_of([&] { small.solve(Positions(Positions::Zero(1, 3)), 0.5, pose); }),
            "the pose is not one of this mesh's 8 vertices");
  EXPECT_EQ(message_of([&] { small.pose_at(Positions::Zero(3, 3)); }),
            "3 positions were given for 8 vertices");
}

}  // namespace
}  // namespace flexkey
