#include "flexkey/gltf/fit_targets.h"

#include <gtest/gtest.h>

#include <Eigen/QR>

#include "flexkey/gltf/knot_basis.h"
#include "flexkey/gltf/pca_basis.h"
#include "motions.h"

namespace flexkey {
namespace {

using namespace testing;  // NOLINT

/// Unit vectors that turn with the frames; those of the first vertices never do.
Positions attribute_at(const Frames& frames, std::size_t frame) {
  Positions rows = frames.frames[frame].rowwise().normalized();
  rows.topRows(5).rowwise() = Eigen::RowVector3d(0, 0.6, 0.8);
  return rows;
}

/// A column of the attribute's deltas over time, solved for plainly.
Eigen::VectorXd oracle(const Basis& basis, const Frames& frames, const Positions& rest, Eigen::Index vertex) {
  Eigen::VectorXd deltas(frames.frames.size());
  for (std::size_t k = 0; k < frames.frames.size(); ++k) {
    deltas[static_cast<Eigen::Index>(k)] = attribute_at(frames, k)(vertex, 1) - rest(vertex, 1);
  }
  return weights_at_frames(basis, frames.numbers).colPivHouseholderQr().solve(deltas);
}

TEST(FitTargets, IsTheLeastSquaresAnswer) {
  const Frames frames = frames_of(bent, eased(evenly(40)));
  Frames at_rest = frames;
  at_rest.frames = {frames.rest};
  const Positions rest = attribute_at(at_rest, 0);
  for (const Basis& basis : {knot_basis(frames.motion(), 0.02), pca_basis(frames.motion(), 0.02)}) {
    std::vector<std::size_t> asked;
    const std::vector<FloatRows> targets = fit_targets(
        basis, frames.numbers, rest,
        [&](std::size_t k) {
          asked.push_back(k);
          return attribute_at(frames, k);
        },
        1e-6);
    EXPECT_EQ(asked.size(), frames.frames.size());
    ASSERT_EQ(targets.size(), basis.targets.size());
    for (const Eigen::Index vertex : {20, 89}) {
      const Eigen::VectorXd expected = oracle(basis, frames, rest, vertex);
      for (std::size_t t = 0; t < targets.size(); ++t) {
        EXPECT_NEAR(targets[t](vertex, 1), expected[static_cast<Eigen::Index>(t)], 1e-5);
        EXPECT_TRUE(targets[t].topRows(5).isZero(0));
      }
    }
  }
}

TEST(FitTargets, HasNothingToFitWithoutTargets) {
  const Frames frames = frames_of(bent, {0, 0});
  const Basis basis = knot_basis(frames.motion(), 0);
  EXPECT_TRUE(fit_targets(
                  basis, frames.numbers, frames.rest, [&](std::size_t k) { return frames.frames[k]; }, 0)
                  .empty());
}

}  // namespace
}  // namespace flexkey
