#include "flexkey/timeline/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "timeline/parsing.h"

namespace flexkey {
namespace {

constexpr double pi = std::numbers::pi;

/// The slope of a function by central differences.
template <class Function>
double slope_of(const Function& f, double t) {
  constexpr double h = 1e-6;
  return (f(t + h) - f(t - h)) / (2 * h);
}

TEST(SampleLambda, HoldsOutsideAndMeetsEveryKeyToTheBit) {
  const Track<double> lambda =
      parse(with_base("lambda: {1s: 0.1, 2s: 0.3, 3.3s: 0.7}\nease: ease-in-out\n")).lambda;
  EXPECT_EQ(sample_lambda(lambda, 0), 0.1);
  EXPECT_EQ(sample_lambda(lambda, 99), 0.7);
  for (const Key<double>& key : lambda) EXPECT_EQ(sample_lambda(lambda, key.time), key.value);
}

TEST(SampleLambda, LinearIsAStraightLine) {
  const Track<double> lambda = parse(with_base("lambda: {1s: 0, 3s: 1}\n")).lambda;
  EXPECT_DOUBLE_EQ(sample_lambda(lambda, 1.5), 0.25);
  EXPECT_DOUBLE_EQ(sample_lambda(lambda, 2.5), 0.75);
}

TEST(SampleLambda, HoldJumpsAtTheNextKey) {
  const Track<double> lambda = parse(with_base("lambda: {keys: {0s: 0.2, 1s: 0.9}, ease: hold}\n")).lambda;
  EXPECT_EQ(sample_lambda(lambda, 0.999), 0.2);
  EXPECT_EQ(sample_lambda(lambda, 1), 0.9);
}

TEST(SampleLambda, AnOvershootIsClamped) {
  const Track<double> lambda =
      parse(with_base("lambda: {keys: {0s: 0, 1s: 1}, ease: [0.3, -2, 0.7, 3]}\n")).lambda;
  double low = 1, high = 0;
  for (double t = 0; t <= 1; t += 0.01) {
    low = std::min(low, sample_lambda(lambda, t));
    high = std::max(high, sample_lambda(lambda, t));
  }
  EXPECT_EQ(low, 0);
  EXPECT_EQ(high, 1);
}

TEST(SampleLambda, SmoothIsMonotoneBetweenKeysAndSmoothAtThem) {
  const Track<double> lambda =
      parse(with_base("lambda: {keys: {0s: 0, 1s: 0.05, 2s: 0.9, 5s: 1, 6s: 1, 7s: 0.2}, ease: smooth}\n"))
          .lambda;
  const auto f = [&](double t) { return sample_lambda(lambda, t); };
  for (std::size_t i = 0; i + 1 < lambda.size(); ++i) {
    const bool falls = lambda[i + 1].value < lambda[i].value;
    double before = lambda[i].value;
    for (double t = lambda[i].time; t <= lambda[i + 1].time; t += 0.01) {
      EXPECT_TRUE(falls ? f(t) <= before + 1e-15 : f(t) >= before - 1e-15) << t;
      before = f(t);
    }
    EXPECT_EQ(f(lambda[i].time), lambda[i].value);
  }
  for (const double t : {1.0, 2.0, 5.0, 6.0}) {
    const double h = 1e-5;
    const double left = (f(t) - f(t - h)) / h, right = (f(t + h) - f(t)) / h;
    EXPECT_NEAR(left, right, 1e-3) << "C1 at the key at " << t;
  }
}

TEST(SampleMotion, WithoutTracksIsRest) {
  const Handle handle;
  const HandleMotion motion = sample_motion(handle, Vec3(1, 2, 3), 0.7);
  EXPECT_EQ(motion.apply(Vec3(0.1, 0.7, 9), Vec3(1, 2, 3)), Vec3(0.1, 0.7, 9));
}

TEST(SampleMotion, TracksAreIndependentAndHoldBeforeTheirFirstKey) {
  const Handle tip = parse_tip(
      "    move: {keys: {1s: [1, 2, 3], 2s: [3, 2, 1]}}\n"
      "    scale: {keys: {0s: 1, 4s: [3, 1, 1]}}\n");
  const HandleMotion start = sample_motion(tip, Vec3::Zero(), 0);
  EXPECT_EQ(start.move, Vec3(1, 2, 3));
  EXPECT_EQ(start.scale, Vec3(1, 1, 1));
  const HandleMotion middle = sample_motion(tip, Vec3::Zero(), 1.5);
  EXPECT_TRUE(middle.move.isApprox(Vec3(2, 2, 2), 1e-15));
  EXPECT_TRUE(middle.scale.isApprox(Vec3(1.75, 1, 1), 1e-15));
  EXPECT_EQ(sample_motion(tip, Vec3::Zero(), 2).move, Vec3(3, 2, 1));
  EXPECT_EQ(sample_motion(tip, Vec3::Zero(), 9).scale, Vec3(3, 1, 1));
}

TEST(SampleMotion, IsScaleThenRotateThenMoveAboutThePivot) {
  HandleMotion motion;
  motion.scale = Vec3(2, 1, 1);
  motion.rotation = {Vec3::UnitZ(), pi / 2};
  motion.move = Vec3(0, 0, 5);
  const Vec3 pivot(1, 1, 0);
  EXPECT_TRUE(motion.apply(Vec3(2, 1, 0), pivot).isApprox(Vec3(1, 3, 5), 1e-14));
  EXPECT_TRUE(motion.apply(pivot, pivot).isApprox(Vec3(1, 1, 5), 1e-14));
}

TEST(SampleMotion, ToSaysWhereThePivotGoes) {
  const Handle tip =
      parse_tip("    to: {keys: {0s: [1, 0, 0], 1s: [0, 1, 0]}}\n    rotate: {axis: x, keys: {0s: 1rad}}\n");
  const Vec3 pivot(5, 6, 7);
  EXPECT_TRUE(sample_motion(tip, pivot, 0).apply(pivot, pivot).isApprox(Vec3(1, 0, 0), 1e-14));
  EXPECT_TRUE(sample_motion(tip, pivot, 0.5).apply(pivot, pivot).isApprox(Vec3(0.5, 0.5, 0), 1e-14));
}

TEST(SampleMotion, TheAngleItselfIsInterpolated) {
  const Handle tip = parse_tip("    rotate: {axis: z, keys: {0s: 0deg, 3s: 720deg}}\n");
  EXPECT_DOUBLE_EQ(sample_motion(tip, Vec3::Zero(), 1.5).rotation.angle, 2 * pi);
  EXPECT_DOUBLE_EQ(sample_motion(tip, Vec3::Zero(), 3).rotation.angle, 4 * pi);
  EXPECT_DOUBLE_EQ(sample_motion(tip, Vec3::Zero(), 0.375).rotation.angle, pi / 2);
}

TEST(SampleMotion, KeysWithAxesOfTheirOwnAreSlerped) {
  const Handle tip =
      parse_tip("    rotate: {keys: {0s: {axis: x, angle: 90deg}, 1s: {axis: z, angle: 90deg}}}\n");
  const auto turn_at = [&](double t) {
    const AxisAngle turn = sample_motion(tip, Vec3::Zero(), t).rotation;
    return Eigen::Quaterniond(Eigen::AngleAxisd(turn.angle, turn.axis));
  };
  const Eigen::Quaterniond start(Eigen::AngleAxisd(pi / 2, Vec3::UnitX())),
      end(Eigen::AngleAxisd(pi / 2, Vec3::UnitZ()));
  for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    EXPECT_NEAR(turn_at(t).angularDistance(start.slerp(t, end)), 0, 1e-7) << t;
  }
  EXPECT_EQ(sample_motion(tip, Vec3::Zero(), 1).rotation.axis, Vec3::UnitZ()) << "the key itself at its time";
}

TEST(SampleMotion, AHalfTurnIsSlerpedWithoutNan) {
  const Handle tip =
      parse_tip("    rotate: {keys: {0s: {axis: z, angle: 0deg}, 1s: {axis: x, angle: 180deg}}}\n");
  const AxisAngle middle = sample_motion(tip, Vec3::Zero(), 0.5).rotation;
  EXPECT_NEAR(middle.angle, pi / 2, 1e-12);
  EXPECT_TRUE(middle.axis.isApprox(Vec3::UnitX(), 1e-12));
}

TEST(SampleMotion, SmoothGoesThroughItsKeysWithOneSlopeAtEach) {
  const Handle tip = parse_tip(
      "    move: {keys: {0s: [0, 0, 0], 1s: [1, 0, 0], 3s: [2, 5, 0], 4s: [0, 0, 0]}, ease: smooth}\n"
      "    rotate: {keys: {0s: {axis: x, angle: 0deg}, 1s: {axis: x, angle: 90deg}, 2s: {axis: z, angle: "
      "90deg}},"
      " ease: smooth}\n");
  const auto x = [&](double t) { return sample_motion(tip, Vec3::Zero(), t).move.x(); };
  EXPECT_EQ(x(1), 1);
  EXPECT_EQ(x(3), 2);
  EXPECT_NEAR(slope_of(x, 1), 2.0 / 3, 1e-4) << "(2 - 0) / (3 - 0)";
  EXPECT_NEAR(slope_of(x, 3), -1.0 / 3, 1e-4) << "(0 - 1) / (4 - 1)";
  EXPECT_NEAR(slope_of(x, 0), 0, 1e-4) << "held before the first key";
  const auto upward = [&](double t) {
    return sample_motion(tip, Vec3::Zero(), t).apply(Vec3::UnitY(), Vec3::Zero()).z();
  };
  EXPECT_NEAR((upward(1) - upward(1 - 1e-6)) / 1e-6, (upward(1 + 1e-6) - upward(1)) / 1e-6, 1e-4);
  EXPECT_EQ(sample_motion(tip, Vec3::Zero(), 1).rotation.angle, pi / 2);
}

TEST(SampleMotion, TheEasingOfAKeyIsThatOfTheStretchAfterIt) {
  const Handle tip = parse_tip(
      "    move:\n"
      "      ease: hold\n"
      "      keys:\n"
      "        - {at: 2s, value: [2, 0, 0]}\n"
      "        - {at: 0s, value: [0, 0, 0], ease: linear}\n"
      "        - {at: 1s, value: [1, 0, 0]}\n");
  const auto x = [&](double t) { return sample_motion(tip, Vec3::Zero(), t).move.x(); };
  EXPECT_DOUBLE_EQ(x(0.5), 0.5) << "its own easing wins over the track's";
  EXPECT_EQ(x(1.9), 1) << "the track's over the file's";
}

Positions bent_chain() {
  Positions chain(4, 3);
  chain << 0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 3, 0;  // shares 0, 1/4, 1/2, 1
  return chain;
}

TEST(SampleCurve, RestIsTheChainToTheBit) {
  const Track<Curve> track = {{0, {}, {}}, {1, {Curve::Kind::polyline, {{0, 0, 0}, {8, 0, 0}}}, {}}};
  EXPECT_EQ(sample_curve(track, bent_chain(), 0), bent_chain());
  EXPECT_EQ(sample_curve(track, bent_chain(), -3), bent_chain());
}

TEST(SampleCurve, KeepsSharesOfArcLengthAndBlendsPointByPoint) {
  const Curve line{Curve::Kind::polyline, {{0, 0, 0}, {8, 0, 0}}};
  const Track<Curve> track = {{0, {}, {}}, {1, line, {}}};
  Positions laid(4, 3);
  laid << 0, 0, 0, 2, 0, 0, 4, 0, 0, 8, 0, 0;
  EXPECT_TRUE(sample_curve(track, bent_chain(), 1).isApprox(laid, 1e-12));
  EXPECT_TRUE(sample_curve(track, bent_chain(), 7).isApprox(laid, 1e-12));
  EXPECT_TRUE(sample_curve(track, bent_chain(), 0.25).isApprox(0.75 * bent_chain() + 0.25 * laid, 1e-12));
}

TEST(SampleCurve, EasesTheBlend) {
  Easing ease_in{Easing::Kind::bezier, 1.0 / 3, 0, 2.0 / 3, 1};  // smoothstep
  const Curve line{Curve::Kind::polyline, {{0, 0, 0}, {8, 0, 0}}};
  const Track<Curve> track = {{0, {}, ease_in}, {1, line, {}}};
  const double s = 0.25 * 0.25 * (3 - 0.5);
  const Positions laid = sample_curve(track, bent_chain(), 1);
  EXPECT_TRUE(sample_curve(track, bent_chain(), 0.25).isApprox((1 - s) * bent_chain() + s * laid, 1e-12));
}

TEST(SampleCurve, DegenerateChainsAndCurvesStayFinite) {
  const Track<Curve> track = {{0, {}, {}}, {1, {Curve::Kind::catmull_rom, {{1, 1, 1}, {1, 1, 1}}}, {}}};
  EXPECT_TRUE(sample_curve(track, Positions::Constant(5, 3, 2.0), 0.5).allFinite());
  EXPECT_TRUE(sample_curve(track, bent_chain(), 1).isApprox(Positions::Constant(4, 3, 1.0)));
  EXPECT_EQ(sample_curve(track, Positions(0, 3), 0.5).rows(), 0);
}

}  // namespace
}  // namespace flexkey
