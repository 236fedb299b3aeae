#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "flexkey/deform/deformer.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

double largest_distance(const Positions& a, const Positions& b) {
  return (a - b).rowwise().norm().maxCoeff();
}

std::vector<int> ends_of(const Mesh& bar, double length) {
  std::vector<int> ends = meshes::between(bar, 0, -1, 0.5);
  for (const int v : meshes::between(bar, 0, length - 0.5, length + 1)) ends.push_back(v);
  return ends;
}

/// Starts at `moved`, whose handles are the targets, and expects to be there still after 20 steps.
void expect_fixed_point(const Mesh& mesh, const Positions& moved, double lambda,
                        const DeformOptions& options) {
  const std::vector<int> handles = ends_of(mesh, mesh.positions.col(0).maxCoeff());
  DeformOptions plain = options;
  plain.iterations = 20;
  plain.predict = plain.accelerate = false;
  plain.fixed_count = true;
  const Deformer deformer(mesh, {handles, {}}, plain);
  Pose pose = deformer.pose_at(moved);
  EXPECT_EQ(deformer.solve(moved(handles, Eigen::all), lambda, pose).solves, 20);
  EXPECT_LT(largest_distance(pose.positions, moved), 1e-9 * bounds_of(moved).diagonal());
}

/// What a shot may ask for beside the system and the local scale.
const std::vector<DeformOptions> kinds{
    {.area_weighting = true, .iterations = 20},
    {.weights = Weights::intrinsic_delaunay, .iterations = 20},
    {.cell = Cell::spokes_and_rims, .iterations = 20},
    {.system = System::direct, .cell = Cell::spokes_and_rims, .iterations = 20},
    {.local_scale = LocalScale::axis,
     .weights = Weights::intrinsic_delaunay,
     .cell = Cell::spokes_and_rims,
     .area_weighting = true,
     .iterations = 20},
};

TEST(Invariance, ARigidMotionOfAllHandlesIsAFixedPoint) {
  const Mesh quads = meshes::bumpy(meshes::bar(6, 2, 1), 0.1);
  const Eigen::Matrix3d turn = meshes::turn(130, {1, 2, -1});
  for (const Mesh& mesh : {quads, meshes::triangulated(quads)}) {
    for (const System system : {System::least_squares, System::direct}) {
      for (const LocalScale kind : {LocalScale::uniform, LocalScale::axis, LocalScale::none}) {
        for (const double lambda : {0.0, 0.5, 1.0}) {
          const DeformOptions options{.system = system, .local_scale = kind};
          expect_fixed_point(mesh, meshes::moved(mesh.positions, turn, {5, -3, 2}), lambda, options);
        }
      }
    }
  }
}

TEST(Invariance, ARigidMotionIsAFixedPointOfEveryKindOfRowsAndCells) {
  const Mesh quads = meshes::bumpy(meshes::bar(6, 2, 1), 0.3);
  const Eigen::Matrix3d turn = meshes::turn(130, {1, 2, -1});
  for (const Mesh& mesh : {quads, meshes::triangulated(quads)}) {
    const Positions moved = meshes::moved(mesh.positions, turn, {5, -3, 2});
    for (const DeformOptions& options : kinds) {
      for (const double lambda : {0.0, 0.5, 1.0}) expect_fixed_point(mesh, moved, lambda, options);
    }
  }
}

TEST(Invariance, ARigidMotionOfALongThinBarIsAFixedPoint) {
  const Mesh mesh = meshes::bar(60, 1, 1);
  const Positions moved = meshes::moved(mesh.positions, meshes::turn(70, {1, 1, 0}), {20, 10, 0});
  for (const System system : {System::least_squares, System::direct}) {
    for (const double lambda : {0.0, 0.5, 1.0}) expect_fixed_point(mesh, moved, lambda, {.system = system});
  }
}

TEST(Invariance, AUniformScalingIsAFixedPointOfTheSmoothSide) {
  const Mesh mesh = meshes::bumpy(meshes::bar(10, 2, 2), 0.1);
  const Positions larger = meshes::moved(mesh.positions, 1.7 * meshes::turn(40, {1, 0, 2}), {1, 2, 3});
  for (const System system : {System::least_squares, System::direct}) {
    for (const LocalScale kind : {LocalScale::uniform, LocalScale::axis}) {
      expect_fixed_point(mesh, larger, 0, {.system = system, .local_scale = kind});
    }
    expect_fixed_point(mesh, larger, 0, {.system = system, .local_scale = LocalScale::axis, .epsilon = 0});
  }
}

/// A solve of `mesh` with its high end, found by the coordinates of `places`, turned and moved.
struct Solved {
  std::vector<int> handles;
  Positions targets;
};
Solved bent(const Mesh& mesh) {
  Solved bent{ends_of(mesh, 10), {}};
  bent.targets = mesh.positions(bent.handles, Eigen::all);
  for (Eigen::Index h = 0; h < bent.targets.rows(); ++h) {
    if (bent.targets(h, 0) < 5) continue;
    const Vec3 from_middle = bent.targets.row(h).transpose() - Vec3(5, 1, 1);
    bent.targets.row(h) = (meshes::turn(40, {0.3, 1, 0.5}) * from_middle + Vec3(5, 1, 2)).transpose();
  }
  return bent;
}

Positions answer(const Mesh& mesh, const Solved& scene, const DeformOptions& options) {
  const Deformer deformer(mesh, {scene.handles, {}}, options);
  Pose pose = deformer.rest_pose();
  deformer.solve(scene.targets, 0.5, pose);
  return pose.positions;
}

Mesh permuted(const Mesh& mesh, const std::vector<int>& new_index) {
  Mesh result;
  result.positions.resize(mesh.positions.rows(), 3);
  for (int v = 0; v < mesh.vertex_count(); ++v) result.positions.row(new_index[v]) = mesh.positions.row(v);
  for (int f = 0; f < mesh.face_count(); ++f) {
    std::vector<int> face(mesh.face(f).begin(), mesh.face(f).end());
    for (int& v : face) v = new_index[v];
    result.add_face(face);
  }
  return result;
}

const std::vector<DeformOptions> both_systems{{.system = System::least_squares, .iterations = 20},
                                              {.system = System::direct, .iterations = 20}};

TEST(Invariance, PermutingTheVerticesPermutesTheAnswer) {
  const Mesh mesh = meshes::bumpy(meshes::bar(10, 2, 2), 0.1);
  std::vector<int> new_index(mesh.vertex_count());
  std::iota(new_index.begin(), new_index.end(), 0);
  std::shuffle(new_index.begin(), new_index.end(), std::mt19937(7));
  const Mesh shuffled = permuted(mesh, new_index);
  std::vector<DeformOptions> all = both_systems;
  all.insert(all.end(), kinds.begin(), kinds.end());
  for (const DeformOptions& options : all) {
    const Positions plain = answer(mesh, bent(mesh), options);
    const Positions other = answer(shuffled, bent(shuffled), options);
    EXPECT_LT(largest_distance(other(new_index, Eigen::all), plain), 1e-9);
  }
}

TEST(Invariance, TurningTheCornersOfFacesChangesNothing) {
  const Mesh mesh = meshes::bumpy(meshes::bar(10, 2, 2), 0.1);
  Mesh turned;
  turned.positions = mesh.positions;
  for (int f = 0; f < mesh.face_count(); ++f) {
    std::vector<int> face(mesh.face(f).begin(), mesh.face(f).end());
    std::rotate(face.begin(), face.begin() + f % 4, face.end());
    turned.add_face(face);
  }
  for (const DeformOptions& options : both_systems) {
    EXPECT_LT(largest_distance(answer(turned, bent(mesh), options), answer(mesh, bent(mesh), options)), 1e-9);
  }
}

TEST(Invariance, ScalingTheWorldScalesTheAnswer) {
  const Mesh mesh = meshes::bumpy(meshes::bar(10, 2, 2), 0.1);
  const Solved scene = bent(mesh);
  for (const double size : {1e-6, 1e6}) {
    Mesh scaled = mesh;
    scaled.positions *= size;
    const Solved scaled_scene{scene.handles, size * scene.targets};
    for (DeformOptions options : both_systems) {
      for (const LocalScale kind : {LocalScale::uniform, LocalScale::axis}) {
        options.local_scale = kind;
        const Positions expected = size * answer(mesh, scene, options);
        EXPECT_LT(largest_distance(answer(scaled, scaled_scene, options), expected), 1e-9 * size);
      }
    }
  }
}

TEST(Invariance, TurningTheWorldTurnsTheAnswerWithoutAxisScale) {
  const Mesh mesh = meshes::bumpy(meshes::bar(10, 2, 2), 0.1);
  const Solved scene = bent(mesh);
  const Eigen::Matrix3d turn = meshes::turn(100, {1, 1, 3});
  Mesh turned = mesh;
  turned.positions = meshes::moved(mesh.positions, turn, {4, 5, 6});
  const Solved turned_scene{scene.handles, meshes::moved(scene.targets, turn, {4, 5, 6})};
  for (const DeformOptions& options : both_systems) {
    const Positions expected = meshes::moved(answer(mesh, scene, options), turn, {4, 5, 6});
    EXPECT_LT(largest_distance(answer(turned, turned_scene, options), expected), 1e-9);
  }
}

TEST(Invariance, TheSameSolveGivesTheSameBits) {
  const Mesh mesh = meshes::bumpy(meshes::bar(10, 2, 2), 0.1);
  for (const DeformOptions& options : both_systems) {
    EXPECT_EQ(answer(mesh, bent(mesh), options), answer(mesh, bent(mesh), options));
  }
}

}  // namespace
}  // namespace flexkey
