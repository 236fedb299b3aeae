#include "flexkey/deform/rotation.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <random>

#include "support/meshes.h"

namespace flexkey {
namespace {

using Eigen::Matrix3d;

Matrix3d random_matrix(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Matrix3d::NullaryExpr([&] { return normal(random); });
}

Matrix3d random_rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
      .normalized()
      .toRotationMatrix();
}

double score(const Matrix3d& R, const Matrix3d& A) {
  return (R.transpose() * A).trace();
}

void expect_rotation(const Matrix3d& R) {
  EXPECT_LT((R * R.transpose() - Matrix3d::Identity()).norm(), 1e-14);
  EXPECT_NEAR(R.determinant(), 1, 1e-14);
}

/// The textbook fit by singular values.
Matrix3d by_svd(const Matrix3d& A) {
  const Eigen::JacobiSVD<Matrix3d> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  return svd.matrixU() * Vec3(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

/// Of many rotations that reach the best score (found by restarting ascent from random ones), the nearest.
void expect_nearest_of_the_best(const Matrix3d& A, const Matrix3d& previous, std::mt19937& random) {
  const Matrix3d R = best_rotation(A, previous);
  expect_rotation(R);
  for (int k = 0; k < 20; ++k) {
    const Matrix3d other = best_rotation(A, random_rotation(random));
    EXPECT_NEAR(score(other, A), score(R, A), 1e-12);
    EXPECT_GE(score(R, previous), score(other, previous) - 1e-9);
  }
  for (int k = 0; k < 2000; ++k) EXPECT_LE(score(random_rotation(random), A), score(R, A) + 1e-12);
}

TEST(BestRotation, AgreesWithSingularValues) {
  std::mt19937 random(1);
  for (int k = 0; k < 500; ++k) {
    const Matrix3d A = random_matrix(random);
    const Matrix3d R = best_rotation(A, random_rotation(random));
    expect_rotation(R);
    EXPECT_LT((R - by_svd(A)).norm(), 1e-10) << A;
  }
}

TEST(BestRotation, NoRotationScoresHigher) {
  std::mt19937 random(2);
  const Matrix3d A = random_matrix(random);
  const double best = score(best_rotation(A, Matrix3d::Identity()), A);
  for (int k = 0; k < 20000; ++k) EXPECT_LE(score(random_rotation(random), A), best);
}

TEST(BestRotation, OfAFlatCellIsUnique) {
  std::mt19937 random(3);
  for (int k = 0; k < 100; ++k) {
    const Matrix3d turned = random_rotation(random), axes = random_rotation(random);
    const Matrix3d A = turned * axes * Vec3(2, 1, 0).asDiagonal() * axes.transpose();
    const Matrix3d R = best_rotation(A, random_rotation(random));
    EXPECT_LT((R - turned).norm(), 1e-13);
  }
}

TEST(BestRotation, OfAReflectedCellStaysARotation) {
  const Matrix3d A = Vec3(3, 2, -1).asDiagonal();
  EXPECT_LT((best_rotation(A, meshes::turn(170, {1, 2, 3})) - Matrix3d::Identity()).norm(), 1e-13);
}

TEST(BestRotation, OfAZeroCellIsThePrevious) {
  const Matrix3d previous = meshes::turn(50, {1, 2, 3});
  EXPECT_EQ(best_rotation(Matrix3d::Zero(), previous), previous);
}

TEST(BestRotation, OfACollinearCellIsTheNearestToThePrevious) {
  std::mt19937 random(4);
  const Vec3 from = Vec3(1, 2, 3).normalized(), to = Vec3(-2, 1, 0.5).normalized();
  const Matrix3d previous = random_rotation(random), A = to * from.transpose();
  EXPECT_LT((best_rotation(A, previous) * from - to).norm(), 1e-14);
  // The nearest of them adds to `previous` only the shortest turn of its image of the line.
  const Matrix3d shortest = Eigen::Quaterniond::FromTwoVectors(previous * from, to).toRotationMatrix();
  EXPECT_LT((best_rotation(A, previous) - shortest * previous).norm(), 1e-12);
  expect_nearest_of_the_best(A, previous, random);
}

TEST(BestRotation, OfAReflectionWithEqualValuesIsTheNearestToThePrevious) {
  std::mt19937 random(5);
  for (const Vec3& values : {Vec3(3, 1, -1), Vec3(1, 1, -1), Vec3(-1, -1, -1)}) {
    for (int k = 0; k < 5; ++k) {
      const Matrix3d A = random_rotation(random) * values.asDiagonal() * random_rotation(random);
      expect_nearest_of_the_best(A, random_rotation(random), random);
    }
  }
}

TEST(BestRotation, KeepsAPreviousThatIsAlreadyBest) {
  const Matrix3d A = Vec3(3, 1, -1).asDiagonal();
  const Matrix3d previous = meshes::turn(77, {1, 0, 0});  // turning the equal pair costs nothing
  EXPECT_LT((best_rotation(A, previous) - previous).norm(), 1e-14);
}

TEST(BestRotation, DoesNotDependOnTheSizeOfTheWorld) {
  std::mt19937 random(6);
  const Matrix3d A = random_matrix(random), previous = random_rotation(random);
  for (const double size : {1e-20, 1e20}) {
    EXPECT_LT((best_rotation(size * A, previous) - best_rotation(A, previous)).norm(), 1e-13);
  }
}

TEST(BestRotation, FindsHalfATurn) {
  const Matrix3d turned = meshes::turn(180, {0, 0, 1});
  EXPECT_LT((best_rotation(turned, Matrix3d::Identity()) - turned).norm(), 1e-13);
}

}  // namespace
}  // namespace flexkey
