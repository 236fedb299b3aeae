// A solve that stops and goes on gives the bytes of one that does not.
#include <gtest/gtest.h>

#include "animate/state_folder.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

using test::Ending;
using test::expect_same;
using test::held_bar;
using test::shot_of;
using test::solve_in_parts;

class Resume : public test::StateFolder {
 protected:
  /// Stops after each number of frames up to `most`, asked to and killed.
  void expect_same_in_parts(const std::string& text, int most = 3) const {
    const Mesh bar = meshes::bar(2, 2, 8);
    const Shot shot = shot_of(text);
    const Scene scene = bind_shot(shot, bar);
    const Clip whole = animate(shot, bar, scene);
    for (int frames = 1; frames <= most; ++frames) {
      for (const Ending ending : {Ending::asked, Ending::killed}) {
        SCOPED_TRACE(frames);
        std::filesystem::remove_all(folder());
        expect_same(solve_in_parts({shot, scene}, bar, folder(), frames, ending), whole);
      }
    }
  }
};

const std::string bent = held_bar +
                         "  tip:\n"
                         "    select: {axis: z, above: 100%}\n"
                         "    rotate: {axis: x, keys: {0s: 0deg, 1s: 80deg}}\n"
                         "    move: {keys: {0.25s: [0, 0, 0], 1s: [0, 0.6, 0.1]}}\n"
                         "fps: 8\nduration: 1.5s\nlambda: {0s: 0.2, 1s: 0.9}\n";

TEST_F(Resume, KeepsTheAndersonWindowAndWhatTheNextFrameIsPredictedBy) {
  expect_same_in_parts(bent);
}

TEST_F(Resume, WithoutPredictionAndAcceleration) {
  expect_same_in_parts(bent + "solver: {predict: off, accelerate: off}\n");
}

TEST_F(Resume, OfThePaperPresetKnowsThatTheFirstFrameIsOver) {
  expect_same_in_parts(bent + "solver: {preset: paper}\n");
}

TEST_F(Resume, OfTheDirectSystemWithAxisScales) {
  expect_same_in_parts(bent + "solver: {system: direct, local_scale: axis}\n");
}

TEST_F(Resume, WithHandlesThatTakeHoldLetGoAndFade) {
  expect_same_in_parts(
      held_bar +
      "  side: {select: {axis: z, above: 40%, below: 55%}, active: [0.25s, 0.75s], move: {keys: {0s: [0, 0, "
      "0], 1s: [1, 0, 0]}}}\n"
      "  tip:\n"
      "    select: {axis: z, above: 100%}\n"
      "    active: [0.5s, 1.75s]\n"
      "    fade: 0.5s\n"
      "    move: {keys: {0s: [0, 0, 0], 1s: [0, 2, 0]}}\n"
      "fps: 8\nduration: 2s\nlambda: 0.4\n");
}

TEST_F(Resume, WithSoftAndRigidParts) {
  expect_same_in_parts(bent + "rigid: {middle: {axis: z, above: 40%, below: 60%}}\n" +
                       "solver: {tolerance: 0.01%}\n");
  expect_same_in_parts(
      held_bar +
      "  tip: {select: {axis: z, above: 100%}, weight: 0.5, rotate: {axis: z, keys: {0s: 0deg, "
      "1s: 90deg}}}\nfps: 8\n");
}

TEST_F(Resume, RemembersTheTurnsByWhichASlipIsKnown) {
  const std::string text = held_bar +
                           "  tip: {select: {axis: z, above: 100%}, rotate: {axis: z, keys: {0s: 0deg, 1s: "
                           "540deg}}}\nfps: 24\n";
  const Clip whole = animate(shot_of(text), meshes::bar(2, 2, 8));
  ASSERT_TRUE(whole.reports.back().slipped);
  expect_same_in_parts(text, 2);
}

TEST_F(Resume, OfCurves) {
  expect_same_in_parts(
      "mesh: bar.obj\nhandles:\n  base: {select: {axis: z, below: 0%}}\n"
      "  ridge:\n    select: {path: [[0, 0, 4], [0, 0, 8]]}\n"
      "    curve: {keys: {0s: rest, 1s: {polyline: [[0, 0, 4], [0, 1, 7], [0, 3, 8]]}}}\nfps: 6\n");
}

TEST_F(Resume, OfHandlesThatFollowTheirParentsAndSway) {
  expect_same_in_parts(
      "mesh: bar.obj\nhandles:\n"
      "  base: {select: {axis: z, below: 0%}, rotate: {axis: y, keys: {0s: 0deg, 1s: 100deg}}}\n"
      "  tip: {select: {axis: z, above: 100%}, parent: base, noise: {amplitude: 0.2, frequency: 3, along: "
      "x}, "
      "rotate: {axis: z, keys: {0s: 0deg, 1s: 60deg}}}\nfps: 8\n");
}

TEST_F(Resume, WithLambdaPaintedInRegions) {
  std::string painted = bent;
  painted.replace(painted.find("lambda:"), std::string::npos,
                  "lambda: {keys: {0s: 0.2, 1s: 0.9}, regions: [{select: {axis: z, above: 60%}, value: 1, "
                  "feather: 5%}]}\n");
  expect_same_in_parts(painted, 2);
}

TEST_F(Resume, OfRunsSolvedTogetherThatStoppedAtDifferentFrames) {
  const Mesh bar = meshes::bar(2, 2, 8);
  std::vector<Shot> shots(3, shot_of(bent));
  for (std::size_t k = 0; k < shots.size(); ++k) shots[k].lambda = {{0, 0.3 * static_cast<double>(k), {}}};
  const Scene scene = bind_shot(shots[0], bar);
  std::vector<TakeState> states;
  std::vector<Take> takes;
  states.reserve(shots.size());
  for (std::size_t k = 0; k < shots.size(); ++k) {
    const Take take{shots[k], scene};
    const std::filesystem::path place = folder() / std::to_string(k);
    TakeState before(place, take, "test");
    test::solve_on(take, bar, before, static_cast<int>(5 * k));  // the last of them to within two of its end
    states.emplace_back(place, take, "test");
    takes.push_back({shots[k], scene, &states.back()});
  }
  const std::vector<Clip> clips = animate(takes, bar);
  for (std::size_t k = 0; k < shots.size(); ++k) expect_same(clips[k], animate(shots[k], bar, scene));
}

TEST_F(Resume, GivesTheWantedFramesAlone) {
  const Mesh bar = meshes::bar(2, 2, 8);
  const Shot shot = shot_of(bent);
  const Scene scene = bind_shot(shot, bar);
  const Clip whole = animate(shot, bar, scene);
  TakeState before(folder(), {shot, scene}, "test");
  test::solve_on({shot, scene}, bar, before, 6);
  const std::vector<int> wanted{2, 5, 8};
  const TakeState state(folder(), {shot, scene}, "test", wanted);
  const Take take{shot, scene, &state};
  int heard = 0, solved = 0;
  AnimateHooks hooks;
  hooks.on_frame = [&](std::size_t, const FrameReport& report) { EXPECT_EQ(report.frame, heard++); };
  hooks.on_solved = [&](std::size_t, const SolvedStep& step) { EXPECT_EQ(step.report.frame, 6 + solved++); };
  const Clip clip = animate(std::span(&take, 1), bar, wanted, hooks).front();
  ASSERT_EQ(clip.frames.size(), wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k)
    EXPECT_EQ(clip.frames[k], whole.frames[static_cast<std::size_t>(wanted[k])]);
  EXPECT_EQ(heard, 9);
  EXPECT_EQ(solved, 3);
}

}  // namespace
}  // namespace flexkey
