#include "flexkey/deform/surface_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "flexkey/deform/deformer.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

TEST(SurfaceOrder, GivesEachVertexAPlaceOfItsOwn) {
  const Mesh mesh = meshes::bar(3, 3, 6);
  for (const System system : {System::least_squares, System::direct}) {
    std::vector<int> places = surface_order(mesh, {.system = system});
    ASSERT_EQ(places.size(), static_cast<std::size_t>(mesh.vertex_count()));
    std::sort(places.begin(), places.end());
    for (int k = 0; k < mesh.vertex_count(); ++k) EXPECT_EQ(places[k], k);
  }
}

TEST(SurfaceOrder, OfSomeVerticesIsTheirOwn) {
  const Permutation order = order_of({50, 7, 900, 8});
  EXPECT_EQ(order.indices(), Eigen::Vector4i(2, 0, 3, 1));
}

TEST(SurfaceOrder, GivesTheSameAnswerForEverySetOfConstraints) {
  const Mesh mesh = meshes::bumpy(meshes::bar(3, 3, 9), 0.1);
  for (const System system : {System::least_squares, System::direct}) {
    const DeformOptions options{.system = system, .iterations = 20};
    const std::vector<int> order = surface_order(mesh, options);
    for (const double top : {5.5, 7.5}) {
      Constraints constraints{meshes::between(mesh, 2, -1, 0.5)};
      const std::vector<int> high = meshes::between(mesh, 2, top, 10);
      constraints.rigid = {meshes::between(mesh, 2, 2.5, 3.5)};
      constraints.handles.insert(constraints.handles.end(), high.begin(), high.end());
      Positions targets = mesh.positions(constraints.handles, Eigen::all);
      targets.bottomRows(static_cast<Eigen::Index>(high.size())).rowwise() += Eigen::RowVector3d(1, 2, 0);
      const Deformer own(mesh, constraints, options), shared(mesh, constraints, options, order);
      Pose a = own.rest_pose(), b = shared.rest_pose();
      own.solve(targets, 0.5, a);
      shared.solve(targets, 0.5, b);
      EXPECT_LT((a.positions - b.positions).rowwise().norm().maxCoeff(), 1e-8);
    }
  }
}

TEST(SurfaceOrder, OfAnotherMeshIsRefused) {
  const Mesh mesh = meshes::cube();
  EXPECT_THROW(Deformer(mesh, {{0}}, {}, {0, 1, 2}), DeformError);
}

TEST(Adopt, GoesOnFromTheShapeUnderOtherConstraints) {
  const Mesh mesh = meshes::bumpy(meshes::bar(2, 2, 8), 0.1);
  const std::vector<int> low = meshes::between(mesh, 2, -1, 0.5), upper = meshes::between(mesh, 2, 3.5, 9);
  Constraints wide{low}, narrow{low};
  wide.handles.insert(wide.handles.end(), upper.begin(), upper.end());
  const Deformer held(mesh, wide), released(mesh, narrow);
  const Eigen::Matrix3d turn = meshes::turn(100, Vec3::UnitZ());
  Positions targets = mesh.positions(wide.handles, Eigen::all);
  const auto count = static_cast<Eigen::Index>(upper.size());
  targets.bottomRows(count) = meshes::moved(targets.bottomRows(count), turn, {0, 0, 0});
  Pose before = held.rest_pose();
  held.solve(targets, 0.5, before);
  const Pose after = released.adopt(before);
  EXPECT_EQ(after.positions, before.positions);
  EXPECT_FALSE(after.converged);
  // What lay deep in the handle had no cell to fit, and has one now.
  const int top = meshes::between(mesh, 2, 7.5, 9).front();
  EXPECT_LT((after.rotations[top] - turn).norm(), 1e-9);
}

}  // namespace
}  // namespace flexkey
