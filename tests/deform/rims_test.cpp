#include "flexkey/deform/rims.h"

#include <gtest/gtest.h>

#include <random>

#include "deform/dense_paper.h"
#include "deform/plain_steps.h"
#include "flexkey/deform/residual.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

constexpr Weights all_kinds[] = {Weights::clamped, Weights::cotangent, Weights::intrinsic_delaunay};

std::vector<Mesh> rest_shapes() {
  return {meshes::tetrahedron(), meshes::grid(4, 3), meshes::bumpy(meshes::bar(5, 2, 1), 0.3),
          meshes::triangulated(meshes::bumpy(meshes::bar(4, 2, 2), 0.3)),
          meshes::bumpy(meshes::sphere(2), 0.2)};
}

Positions noise(Eigen::Index rows, std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Positions::NullaryExpr(rows, 3, [&] { return normal(random); });
}

/// A mesh with vertex 0 held, and its cells of spokes and rims.
struct Rimmed {
  Mesh mesh;
  Patch patch;
  std::vector<WeightedTriangle> triangles;
  CellTables tables;

  Rimmed(const Mesh& rest, System system, Weights weights)
      : mesh(rest),
        patch(patch_of(rest, system, weights)),
        triangles(build_triangles(rest, weights)),
        tables(tabulate(patch)) {
    add_rims(triangles, patch, tables);
  }

  static Patch patch_of(const Mesh& rest, System system, Weights weights) {
    std::vector<bool> is_free(rest.vertex_count(), true);
    is_free[0] = false;
    return make_patch(build_cells(rest, weights), rest.positions, is_free, system);
  }
};

TEST(Rims, TheTrianglesOfAnEdgeSumToItsWeight) {
  for (const Mesh& mesh : rest_shapes()) {
    for (const Weights weights : all_kinds) {
      Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(mesh.vertex_count(), mesh.vertex_count());
      for (const auto& [corners, shares, share] : build_triangles(mesh, weights)) {
        for (std::size_t k = 0; k < 3; ++k) {
          sums(corners[(k + 1) % 3], corners[(k + 2) % 3]) += shares[k];
          sums(corners[(k + 2) % 3], corners[(k + 1) % 3]) += shares[k];
        }
      }
      const Cells cells = build_cells(mesh, weights);
      for (int i = 0; i < cells.count(); ++i) {
        for (const auto [j, weight] : cells.of(i)) {
          EXPECT_NEAR(sums(i, j), weight, 1e-14 * (1 + std::abs(weight)));
          sums(i, j) = 0;
        }
      }
      EXPECT_EQ(sums.norm(), 0);
    }
  }
}

/// Σ ω e′ eᵀ over all edges of the triangles around a mesh vertex, two thirds of each.
Eigen::Matrix3d rim_moments(const Rimmed& at, const Positions& deformed, int vertex) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  for (const auto& [corners, shares, share] : at.triangles) {
    if (std::count(corners.begin(), corners.end(), vertex) == 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
      const Vec3 e = at.mesh.positions.row(a) - at.mesh.positions.row(b);
      const Vec3 e_deformed = deformed.row(a) - deformed.row(b);
      A += 2.0 / 3 * shares[k] * e_deformed * e.transpose();
    }
  }
  return A;
}

TEST(Rims, TheLocalStepFitsAllEdgesOfTheTrianglesAround) {
  std::mt19937 random(1);
  for (const Mesh& mesh : rest_shapes()) {
    for (const Weights weights : all_kinds) {
      const Rimmed at(mesh, System::least_squares, weights);
      const Positions turned = meshes::moved(mesh.positions, meshes::turn(70, {1, 2, 3}), {1, 2, 3});
      const Positions deformed = turned + 0.05 * noise(mesh.vertex_count(), random);
      for (const LocalScale kind : {LocalScale::uniform, LocalScale::axis}) {
        const DeformOptions options{.local_scale = kind};
        Transforms found{std::vector<Eigen::Matrix3d>(at.patch.fitted, meshes::turn(60, {1, 2, 3})),
                         Positions::Ones(at.patch.fitted, 3)};
        const std::vector<Eigen::Matrix3d> previous = found.rotations;
        local_step(at.tables, options, deformed(at.patch.vertices, Eigen::all), found);
        for (int i = 0; i < at.patch.fitted; ++i) {
          const Eigen::Matrix3d A = rim_moments(at, deformed, at.patch.vertices[i]);
          const Eigen::Matrix3d C = rim_moments(at, mesh.positions, at.patch.vertices[i]);
          const Eigen::Matrix3d R = best_rotation(A, previous[i]);
          EXPECT_LT((found.rotations[i] - R).norm(), 1e-9);
          const Vec3 scale = plain::best_scale(A, C, R, options);
          EXPECT_LT((found.scales.row(i).transpose() - scale).norm(), 1e-9 * (1 + scale.norm()));
        }
      }
    }
  }
}

/// Eq 4 with Σ_t ω_ij^t (R_i + R_j + R_k)/3 e_ij for its rigid part, by mesh vertex.
Positions right_hand_side(const Rimmed& at, const Transforms& transforms, const Eigen::VectorXd& lambda) {
  const Positions& p = at.mesh.positions;
  std::vector<Eigen::Matrix3d> R(p.rows());
  for (int i = 0; i < at.patch.fitted; ++i) R[at.patch.vertices[i]] = transforms.rotations[i];
  Positions rigid = Positions::Zero(p.rows(), 3), delta = rigid, r(at.patch.rows, 3);
  for (const auto& [corners, shares, share] : at.triangles) {
    const Eigen::Matrix3d mean = (R[corners[0]] + R[corners[1]] + R[corners[2]]) / 3;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
      const Vec3 e = shares[k] * (p.row(a) - p.row(b));
      rigid.row(a) += mean * e;
      rigid.row(b) -= mean * e;
      delta.row(a) += e;
      delta.row(b) -= e;
    }
  }
  for (int i = 0; i < at.patch.rows; ++i) {
    const int v = at.patch.vertices[i];
    const Vec3 turned = transforms.rotations[i] * delta.row(v).transpose();
    const Vec3 smooth = transforms.scales.row(i).transpose().cwiseProduct(turned);
    r.row(i) = lambda(i) * rigid.row(v) + (1 - lambda(i)) * smooth.transpose();
  }
  return r;
}

TEST(Rims, TheResidualTurnsEachTrianglesEdgesByItsMeanRotation) {
  std::mt19937 random(2);
  for (const Mesh& mesh : rest_shapes()) {
    for (const Weights weights : all_kinds) {
      for (const System system : {System::least_squares, System::direct}) {
        const Rimmed at(mesh, system, weights);
        Transforms transforms{{}, noise(at.patch.fitted, random)};
        for (int i = 0; i < at.patch.fitted; ++i)
          transforms.rotations.push_back(meshes::turn(37.0 * i, noise(1, random).transpose()));
        const Eigen::VectorXd lambda = Eigen::VectorXd::LinSpaced(at.patch.vertex_count(), 0, 1);
        const Positions p = at.patch.rest + noise(at.patch.vertex_count(), random);
        const Positions expected =
            right_hand_side(at, transforms, lambda) - plain::laplacian(at.patch.cells, at.patch.rows, p);
        Positions found;
        residual(at.tables, p, transforms, lambda, found);
        EXPECT_LT((found - expected).norm(), 1e-13 * expected.norm());
      }
    }
  }
}

/// Σ_t Σ_{e ∈ t} ω_e^t Σ_{i ∈ t} |e′ − R_i e|² at the best R_i.
double rim_energy(const Rimmed& at, const Positions& deformed) {
  std::vector<Eigen::Matrix3d> R;
  for (int v = 0; v < at.mesh.vertex_count(); ++v)
    R.push_back(best_rotation(rim_moments(at, deformed, v), Eigen::Matrix3d::Identity()));
  double energy = 0;
  for (const auto& [corners, shares, share] : at.triangles) {
    for (const int i : corners) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
        const Vec3 e = at.mesh.positions.row(a) - at.mesh.positions.row(b);
        const Vec3 e_deformed = deformed.row(a) - deformed.row(b);
        energy += shares[k] * (e_deformed - R[i] * e).squaredNorm();
      }
    }
  }
  return energy;
}

TEST(Rims, RigidDirectStepsLowerTheirOwnEnergy) {
  const Mesh quads = meshes::bumpy(meshes::bar(5, 2, 1), 0.15);
  for (const Mesh& mesh : {quads, meshes::triangulated(quads)}) {
    for (const Weights weights : {Weights::clamped, Weights::intrinsic_delaunay}) {
      const Rimmed at(mesh, System::direct, weights);
      std::vector<int> held = meshes::between(mesh, 0, -1, 0.5);
      for (const int v : meshes::between(mesh, 0, 4.5, 9)) held.push_back(v);
      Positions bent = mesh.positions;
      for (Eigen::Index v = 0; v < bent.rows(); ++v) {
        const Vec3 p = mesh.positions.row(v);
        bent.row(v) =
            (meshes::turn(15 * p.x(), {0.3, 1, 0.5}) * Vec3(1.2 * p.x(), p.y(), 0.9 * p.z())).transpose();
      }
      const Deformer deformer(mesh, {held, {}},
                              {.system = System::direct,
                               .weights = weights,
                               .cell = Cell::spokes_and_rims,
                               .iterations = 1,
                               .predict = false,
                               .accelerate = false,
                               .fixed_count = true});
      Pose pose = deformer.pose_at(bent);
      double energy = rim_energy(at, pose.positions);
      for (int k = 0; k < 30; ++k) {
        deformer.solve(bent(held, Eigen::all), 1, pose);
        const double next = rim_energy(at, pose.positions);
        EXPECT_LT(next, energy);
        energy = next;
      }
    }
  }
}

TEST(Rims, BendAFlatSheetEvenly) {
  const Mesh sheet = meshes::triangulated(meshes::grid(12, 2));
  std::vector<int> held = meshes::between(sheet, 0, -1, 1.5);
  const std::vector<int> high = meshes::between(sheet, 0, 10.5, 13);
  held.insert(held.end(), high.begin(), high.end());
  // The high end goes along an arc of 60 degrees as long as what is free of the sheet.
  const double angle = std::numbers::pi / 3, radius = 10 / angle;
  Positions targets = sheet.positions(held, Eigen::all);
  for (Eigen::Index k = 0; k < targets.rows(); ++k) {
    if (targets(k, 0) < 6) continue;
    const Vec3 end(1 + radius * std::sin(angle), 1, radius * (1 - std::cos(angle)));
    const Vec3 from_end = targets.row(k).transpose() - Vec3(11, 1, 0);
    targets.row(k) = (meshes::turn(-60, {0, 1, 0}) * from_end + end).transpose();
  }
  const Deformer deformer(sheet, {held, {}}, {.cell = Cell::spokes_and_rims, .iterations = 1000});
  Pose pose = deformer.rest_pose();
  EXPECT_TRUE(deformer.solve(targets, 1, pose).converged);
  for (const int v : meshes::between(sheet, 0, 1.5, 10.5)) {
    const double at = (sheet.positions(v, 0) - 1) / radius;
    const Vec3 on_arc(1 + radius * std::sin(at), sheet.positions(v, 1), radius * (1 - std::cos(at)));
    EXPECT_LT((pose.positions.row(v).transpose() - on_arc).norm(), 0.3);
  }
}

}  // namespace
}  // namespace flexkey
