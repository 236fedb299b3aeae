#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/SVD>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "deform/plain_steps.h"
#include "flexkey/deform/local_step.h"
#include "flexkey/deform/residual.h"
#include "support/meshes.h"

/// The frame loop's kernels against the plain steps.
namespace flexkey {
namespace {

/// A disc of n triangles about one vertex.
Mesh fan(int n) {
  std::vector<Vec3> points{{0, 0, 0.3}};
  std::vector<std::vector<int>> faces;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * k / n;
    points.emplace_back(std::cos(angle), std::sin(angle), 0);
    faces.push_back({0, k + 1, (k + 1) % n + 1});
  }
  return meshes::make_mesh(points, faces);
}

Mesh scaled(Mesh mesh, double size) {
  mesh.positions *= size;
  return mesh;
}

/// Meshes of every valence, with and without a border, flat and solid, of n mod 8 cells for many n.
std::vector<Mesh> rest_shapes() {
  return {meshes::tetrahedron(),
          meshes::cube(),
          meshes::grid(1, 1),
          meshes::grid(4, 3),
          meshes::triangulated(meshes::grid(5, 2)),
          meshes::bumpy(meshes::grid(6, 5), 0.3),
          meshes::bumpy(meshes::sphere(3), 0.1),
          scaled(meshes::bumpy(meshes::sphere(1), 0.1), 1e-30),
          scaled(meshes::bumpy(meshes::sphere(1), 0.1), 1e-52),
          scaled(meshes::bumpy(meshes::sphere(1), 0.1), 1e50),
          fan(40),
          meshes::bumpy(meshes::triangulated(meshes::bar(5, 2, 1)), 0.2)};
}

Patch patch_of(const Mesh& mesh, System system = System::least_squares, Weights weights = Weights::clamped) {
  std::vector<bool> is_free(mesh.vertex_count(), true);
  is_free[0] = false;
  return make_patch(build_cells(mesh, weights), mesh.positions, is_free, system);
}

Positions noise(Eigen::Index rows, std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Positions::NullaryExpr(rows, 3, [&] { return normal(random); });
}

Eigen::Matrix3d random_rotation(std::mt19937& random) {
  const Positions q = noise(2, random);
  return Eigen::Quaterniond(q(0, 0), q(0, 1), q(0, 2), q(1, 0)).normalized().toRotationMatrix();
}

/// Where a mesh may have gone, from a rigid motion to what no surface should do.
struct Shape {
  std::string name;
  Positions positions;
};
std::vector<Shape> deformed_shapes(const Positions& rest, std::mt19937& random) {
  const Eigen::Matrix3d turn = random_rotation(random);
  const Vec3 far = rest.norm() * Vec3(3, -2, 1);
  const auto moved = [&](const Eigen::Matrix3d& linear) { return meshes::moved(rest, turn * linear, far); };
  const auto scaled = [&](double x, double y, double z) {
    return moved(Vec3(x, y, z).asDiagonal().toDenseMatrix());
  };
  const Positions jitter = rest.norm() / std::sqrt(rest.rows()) * noise(rest.rows(), random);
  return {{"rest", rest},
          {"turned", moved(Eigen::Matrix3d::Identity())},
          {"stretched", scaled(2, 1, 0.5)},
          {"shaken", rest + 0.05 * jitter},
          {"folded", rest + jitter},
          {"reflected", scaled(1, 1, -1)},
          {"inverted", scaled(-1, -1, -1)},
          {"flat", scaled(1, 1, 0)},
          {"on a line", scaled(0, 2, 0)},
          {"at a point", scaled(0, 0, 0)},
          {"tiny", 1e-170 * rest},
          {"huge", 1e120 * rest}};
}

Transforms turned(int count, const std::vector<Eigen::Matrix3d>& rotations) {
  Transforms transforms{{}, Positions::Ones(count, 3)};
  for (int i = 0; i < count; ++i)
    transforms.rotations.push_back(rotations[static_cast<std::size_t>(i) % rotations.size()]);
  return transforms;
}

/// How far from its opposite the best rotation of A is unique, as a share of |A|: the error of R is that of A
/// over it.
double uniqueness(const Eigen::Matrix3d& A) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  const Vec3 s = svd.singularValues();
  return s(0) > 0 ? (s(1) + sign * s(2)) / s(0) : 0;
}

void expect_same_fit(const Patch& patch, const Shape& shape, const Transforms& previous,
                     const DeformOptions& options) {
  const Transforms expected = plain::local_step(patch, shape.positions, previous, options);
  Transforms found = previous;
  local_step(tabulate(patch), options, shape.positions, found);
  for (int i = 0; i < patch.fitted; ++i) {
    const plain::CellMoments sums = plain::moments(patch, shape.positions, i);
    const double unique = uniqueness(sums.A);
    const double close = unique > 1e-9 ? 1e-12 * (1 + 1e-3 / unique) : 1e-7;
    const Eigen::Matrix3d &R = found.rotations[i], &R_plain = expected.rotations[i];
    EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-13) << shape.name << " " << i;
    EXPECT_LT((R - R_plain).norm(), close) << shape.name << ", cell " << i << "\n"
                                           << sums.A << "\n"
                                           << unique;
    const double size = expected.scales.row(i).norm();
    EXPECT_LE((found.scales.row(i) - expected.scales.row(i)).norm(), 10 * close * size) << shape.name;
  }
}

const std::vector<DeformOptions> scale_options{{.local_scale = LocalScale::uniform},
                                               {.local_scale = LocalScale::axis},
                                               {.local_scale = LocalScale::none}};

TEST(Kernels, TheLocalStepIsThePlainOneOnEveryKindOfCell) {
  std::mt19937 random(1);
  for (const Mesh& mesh : rest_shapes()) {
    const Patch patch = patch_of(mesh);
    for (const Shape& shape : deformed_shapes(patch.rest, random)) {
      for (const DeformOptions& options : scale_options) {
        const Eigen::Matrix3d one = Eigen::Matrix3d::Identity(), other = random_rotation(random);
        expect_same_fit(patch, shape, turned(patch.fitted, {one}), options);
        expect_same_fit(patch, shape, turned(patch.fitted, {other, one, random_rotation(random)}), options);
      }
    }
  }
}

TEST(Kernels, AxisWithoutEpsilonIsThePaperFormOnSolidCells) {
  std::mt19937 random(2);
  const Patch patch = patch_of(meshes::bumpy(meshes::sphere(2), 0.1));
  const Shape shape{"stretched", patch.rest * Vec3(2, 1, 0.5).asDiagonal()};
  expect_same_fit(patch, shape, turned(patch.fitted, {random_rotation(random)}),
                  {.local_scale = LocalScale::axis, .epsilon = 0});
}

TEST(Kernels, ACellThatIsNotFiniteKeepsItsRotationAndSpoilsNoOther) {
  const Patch patch = patch_of(meshes::bumpy(meshes::sphere(2), 0.1));
  const CellTables cells = tabulate(patch);
  const Eigen::Matrix3d before = meshes::turn(20, {1, 1, 0});
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    Positions positions = meshes::moved(patch.rest, meshes::turn(50, {0, 1, 3}), {1, 2, 3});
    Transforms sound = turned(patch.fitted, {before}), spoilt = sound;
    local_step(cells, {}, positions, sound);
    positions(7, 1) = bad;
    local_step(cells, {}, positions, spoilt);
    for (int i = 0; i < patch.fitted; ++i) {
      bool is_touched = i == 7;
      for (const auto [j, weight] : patch.cells.of(i)) is_touched = is_touched || j == 7;
      EXPECT_EQ(spoilt.rotations[i], is_touched ? before : sound.rotations[i]);
    }
  }
}

TEST(Kernels, APreviousThatRoundingSpoiltBecomesARotationAgain) {
  std::mt19937 random(7);
  const Patch patch = patch_of(meshes::bumpy(meshes::sphere(1), 0.1));
  const Eigen::Matrix3d spoilt = Eigen::Matrix3d::Identity() + 1e-9 * noise(3, random);
  Transforms transforms = turned(patch.fitted, {spoilt});
  local_step(tabulate(patch), {}, meshes::moved(patch.rest, meshes::turn(3, {1, 2, 3}), {0, 0, 0}),
             transforms);
  for (const Eigen::Matrix3d& R : transforms.rotations) {
    EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  }
}

TEST(Kernels, ACellsPlaceAmongTheOthersDoesNotMatter) {
  std::mt19937 random(3);
  const Mesh mesh = meshes::bumpy(meshes::sphere(2), 0.1);
  const Positions shaken = mesh.positions + 0.02 * noise(mesh.vertex_count(), random);
  Mesh all = mesh;
  std::vector<Transforms> fits;
  for (int k = 0; k < 9; ++k) {
    all = meshes::joined(k % 2 == 0 ? meshes::grid(2, 2) : meshes::tetrahedron(), all);
    // Others' weights would shift the floor of clamped ones.
    const Patch patch = patch_of(all, System::least_squares, Weights::uniform);
    Positions positions = all.positions;
    positions.bottomRows(mesh.vertex_count()) = shaken;
    Transforms fit = turned(patch.fitted, {Eigen::Matrix3d::Identity()});
    local_step(tabulate(patch), {}, positions(patch.vertices, Eigen::all), fit);
    // The mesh's cells come last, but for the held vertex, one of the others'.
    const auto end = fit.rotations.end() - 1, begin = end - mesh.vertex_count();
    fits.push_back(
        {{begin, end}, fit.scales.bottomRows(mesh.vertex_count() + 1).topRows(mesh.vertex_count())});
  }
  for (const Transforms& fit : fits) {
    EXPECT_EQ(fit.rotations, fits[0].rotations);
    EXPECT_EQ(fit.scales, fits[0].scales);
  }
}

Eigen::VectorXd lambdas(const Patch& patch) {
  return Eigen::VectorXd::LinSpaced(patch.vertex_count(), 0, 1);
}

Transforms random_transforms(int count, std::mt19937& random) {
  Transforms transforms{{}, noise(count, random)};
  for (int i = 0; i < count; ++i) transforms.rotations.push_back(random_rotation(random));
  return transforms;
}

TEST(Kernels, TheResidualIsThePlainRightHandSideLessTheLaplacian) {
  std::mt19937 random(4);
  for (const Mesh& mesh : rest_shapes()) {
    for (const System system : {System::least_squares, System::direct}) {
      const Patch patch = patch_of(mesh, system);
      const Positions p = patch.rest + noise(patch.vertex_count(), random);
      const Transforms transforms = random_transforms(patch.fitted, random);
      const Positions expected = plain::right_hand_side(patch, transforms, lambdas(patch)) -
                                 plain::laplacian(patch.cells, patch.rows, p);
      Positions found;
      residual(tabulate(patch), p, transforms, lambdas(patch), found);
      ASSERT_EQ(found.rows(), patch.rows);
      EXPECT_LT((found - expected).norm(), 1e-14 * expected.norm());
    }
  }
}

TEST(Kernels, TheFreeLaplacianIsThePlainOne) {
  std::mt19937 random(5);
  for (const Mesh& mesh : rest_shapes()) {
    const Patch patch = patch_of(mesh);
    const Positions x = noise(patch.rows, random);
    const Positions expected = plain::laplacian(patch.cells, patch.free, x);
    Positions found;
    free_laplacian(tabulate(patch), x, found);
    ASSERT_EQ(found.rows(), patch.free);
    EXPECT_LT((found - expected).norm(), 1e-14 * expected.norm());
  }
}

TEST(Kernels, GiveTheSameBytesOnAnyNumberOfThreads) {
  std::mt19937 random(6);
  const Patch patch = patch_of(meshes::bumpy(meshes::sphere(5), 0.1));
  const CellTables cells = tabulate(patch);
  const Positions p = patch.rest + 0.02 * noise(patch.vertex_count(), random);
  std::vector<Transforms> fits;
  std::vector<Positions> residuals;
  for (const std::size_t threads : {1, 2, 5}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    fits.push_back(turned(patch.fitted, {Eigen::Matrix3d::Identity()}));
    local_step(cells, {.local_scale = LocalScale::axis}, p, fits.back());
    residual(cells, p, fits.back(), lambdas(patch), residuals.emplace_back());
  }
  for (std::size_t k = 1; k < fits.size(); ++k) {
    EXPECT_EQ(fits[k].rotations, fits[0].rotations);
    EXPECT_EQ(fits[k].scales, fits[0].scales);
    EXPECT_EQ(residuals[k], residuals[0]);
  }
}

}  // namespace
}  // namespace flexkey
