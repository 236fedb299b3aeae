#include "flexkey/gltf/knot_basis.h"

#include <gmock/gmock.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <functional>
#include <random>

#include "motions.h"

namespace flexkey {
namespace {

using namespace testing;  // NOLINT
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// At the keys and halfway between them, where one stretch has begun and the other has not ended.
void expect_blends_of_two(const Basis& basis) {
  std::vector<double> times = basis.keys;
  for (std::size_t k = 0; k + 1 < basis.keys.size(); ++k) {
    times.push_back((basis.keys[k] + basis.keys[k + 1]) / 2);
  }
  const Eigen::MatrixXd weights = weights_at(basis, times);
  EXPECT_GE(weights.minCoeff(), 0);
  EXPECT_LE(weights.rowwise().sum().maxCoeff(), 1 + 1e-6);
  EXPECT_LE((weights.array() > 0).rowwise().count().maxCoeff(), 2);
}

std::size_t targets_of(const Course& course, const std::vector<double>& shares, double tolerance = 0.02) {
  const Frames frames = frames_of(course, shares);
  const Basis basis = knot_basis(frames.motion(), tolerance);
  EXPECT_LE(farthest_shown(basis, frames), tolerance + kRounding);
  return basis.targets.size();
}

TEST(KnotBasis, PlaysWithinTheToleranceAtFramesAndBetween) {
  const Frames frames = frames_of(bent, joined(eased(evenly(40)), reversed(eased(evenly(29)))));
  for (const double tolerance : {0.3, 0.02, 0.001}) {
    const Basis basis = knot_basis(frames.motion(), tolerance);
    EXPECT_LE(farthest_shown(basis, frames), tolerance) << tolerance;
    EXPECT_LE(largest_error(basis, frames.motion()), tolerance) << tolerance;
    EXPECT_LT(basis.targets.size(), frames.frames.size()) << tolerance;
  }
}

TEST(KnotBasis, BlendsTwoTargetsAtMost) {
  const Frames frames = frames_of(circled, joined(eased(evenly(50)), reversed(evenly(17))));
  const Basis basis = knot_basis(frames.motion(), 0.02);
  ASSERT_GT(basis.targets.size(), 2U);
  expect_blends_of_two(basis);
}

/// Shares that drift, stand still, jump, and jump back to where they were.
std::vector<double> wander(std::mt19937& random, int frames) {
  const auto draw = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<double> shares{draw() < 0.5 ? 0 : draw()};
  double speed = 0, mode = 0;
  while (std::ssize(shares) < frames) {
    if (draw() < 0.1) mode = draw();
    speed = mode < 0.5 ? speed + 0.05 * (draw() - 0.5) : 0;
    double next = shares.back() + speed;
    if (mode > 0.9) next = draw();
    if (mode > 0.8 && mode <= 0.9)
      next = shares[static_cast<std::size_t>(draw() * static_cast<double>(shares.size()))];
    shares.push_back(std::clamp(next, 0.0, 1.0));
  }
  return shares;
}

TEST(KnotBasis, HoldsItsPromisesOnAnyMotion) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    const Frames frames =
        frames_of(seed % 2 == 0 ? bent : circled, wander(random, 1 + static_cast<int>(seed)));
    const double tolerance = std::pow(10, -static_cast<double>(seed % 5));
    const Basis basis = knot_basis(frames.motion(), tolerance);
    EXPECT_LE(farthest_shown(basis, frames), tolerance + kRounding) << seed;
    EXPECT_LE(basis.targets.size(), frames.frames.size()) << seed;
    EXPECT_EQ(basis.names.size(), basis.targets.size()) << seed;
    EXPECT_EQ(std::adjacent_find(basis.keys.begin(), basis.keys.end(), std::greater_equal<>()),
              basis.keys.end());
    if (!basis.targets.empty()) expect_blends_of_two(basis);
  }
}

TEST(KnotBasis, TakesOneTargetForAStraightMotionHoweverEased) {
  const Frames even = frames_of(stretched, evenly(30));
  const Basis basis = knot_basis(even.motion(), 0.001);
  EXPECT_EQ(basis.targets.size(), 1U);
  EXPECT_THAT(basis.keys, ElementsAre(0, 30));
  EXPECT_EQ(targets_of(stretched, eased(evenly(30)), 0.001), 1U);
  EXPECT_EQ(targets_of(stretched, joined(eased(evenly(30)), reversed(evenly(7))), 0.001), 1U);
}

TEST(KnotBasis, ComesBackToItsTargets) {
  const std::vector<double> there = eased(evenly(60));
  const std::size_t way_there = targets_of(bent, there);
  EXPECT_GT(way_there, 2U);
  EXPECT_LE(targets_of(bent, joined(there, reversed(there))), way_there + 1);
  EXPECT_LE(targets_of(bent, joined(there, reversed(evenly(83)))), way_there + 1) << "at another speed";
  EXPECT_LE(targets_of(bent, joined(joined(there, reversed(there)), there)), way_there + 1)
      << "and there again";
}

TEST(KnotBasis, TakesNoTargetForRestAndHolds) {
  const std::vector<double> rest(20, 0.0), hold(20, 1.0), there = eased(evenly(60));
  const std::size_t way_there = targets_of(bent, there);
  const std::vector<double> shares = joined(joined(rest, there), joined(hold, joined(reversed(there), rest)));
  EXPECT_LE(targets_of(bent, shares), way_there + 1);
  const Frames frames = frames_of(bent, shares);
  const Eigen::MatrixXd weights = weights_at_frames(knot_basis(frames.motion(), 0.02), frames.numbers);
  EXPECT_LE(weights.topRows(20).maxCoeff(), 1e-6);
  EXPECT_LE(weights.bottomRows(20).maxCoeff(), 1e-6);
}

TEST(KnotBasis, TakesNothingForAClipAtRest) {
  const Frames frames = frames_of(bent, {0, 0, 0});
  const Basis basis = knot_basis(frames.motion(), 0);
  EXPECT_THAT(basis.targets, IsEmpty());
  EXPECT_THAT(basis.names, IsEmpty());
  EXPECT_THAT(basis.keys, ElementsAre(0, 2));
  EXPECT_EQ(basis.weights.rows(), 2);
  EXPECT_EQ(weights_at_frames(basis, frames.numbers).cols(), 0);
  EXPECT_LE(farthest_shown(basis, frames), kRounding);
}

TEST(KnotBasis, TakesShortClips) {
  EXPECT_EQ(targets_of(bent, {1}, 0), 1U);
  EXPECT_EQ(targets_of(bent, {0, 1}, 0), 1U);
  EXPECT_EQ(targets_of(bent, {0.5, 1}, 0), 2U);
  EXPECT_EQ(targets_of(bent, {0.5, 0.5, 0.5, 0.5}, 0), 1U);
  EXPECT_THAT(knot_basis(frames_of(bent, {1}).motion(), 0).keys, ElementsAre(0));
}

TEST(KnotBasis, HonoursGapsBetweenFrames) {
  Frames frames = frames_of(bent, eased(evenly(31)));
  frames.numbers.back() = 47;
  for (int& number : frames.numbers) number += 5;
  const Basis basis = knot_basis(frames.motion(), 0.02);
  EXPECT_EQ(basis.keys.front(), 5);
  EXPECT_EQ(basis.keys.back(), 52);
  EXPECT_LE(farthest_shown(basis, frames), 0.02);
}

TEST(KnotBasis, IsExactToFloatsWithoutATolerance) {
  const Frames frames = frames_of(bent, joined(evenly(20), std::vector<double>(5, 1.0)));
  const Basis basis = knot_basis(frames.motion(), 0);
  EXPECT_LE(farthest_shown(basis, frames), kRounding);
  EXPECT_EQ(basis.targets.size(), 20U) << "no frame but the first is at rest, and none is straight";
}

TEST(KnotBasis, NamesTargetsByTheirFrames) {
  Frames frames = frames_of(bent, {0.25, 1, 0});
  frames.numbers = {3, 42, 12'345};
  EXPECT_THAT(knot_basis(frames.motion(), 0).names, ElementsAre("f0003", "f0042"));
}

TEST(KnotBasis, LeavesExactZerosWhereNothingMoves) {
  Frames frames = frames_of(circled, evenly(30));
  const auto still = [&](Eigen::Index v) { return frames.rest(v, 2) <= 5; };
  for (Positions& frame : frames.frames) frame(0, 0) += 1e-4;  // far below the tolerance
  const Basis basis = knot_basis(frames.motion(), 0.02);
  for (const FloatRows& target : basis.targets) {
    for (Eigen::Index v = 0; v < target.rows(); ++v) EXPECT_EQ(target.row(v).isZero(0), still(v)) << v;
  }
}

TEST(KnotBasis, IsTheSameForAnyNumberOfThreads) {
  const Mesh mesh = meshes::bar(8, 8, 60);  // several blocks of vertices
  Frames frames = frames_of(bent, eased(evenly(20)));
  frames.rest = mesh.positions / 6;
  for (std::size_t k = 0; k < frames.frames.size(); ++k)
    frames.frames[k] = bent(frames.rest, 0.05 * static_cast<double>(k));
  const Basis many = knot_basis(frames.motion(), 0.01);
  Basis one;
  tbb::task_arena(1).execute([&] { one = knot_basis(frames.motion(), 0.01); });
  EXPECT_EQ(one.keys, many.keys);
  EXPECT_EQ(one.weights, many.weights);
  ASSERT_EQ(one.targets.size(), many.targets.size());
  for (std::size_t t = 0; t < one.targets.size(); ++t) EXPECT_EQ(one.targets[t], many.targets[t]);
}

}  // namespace
}  // namespace flexkey
