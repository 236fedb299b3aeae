// What is taken of a state that is there, and what is not.
#include "flexkey/animate/take_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "animate/state_folder.h"
#include "flexkey/mesh/read_file.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

namespace fs = std::filesystem;
using test::expect_same;
using test::held_bar;
using test::shot_of;
using test::solve_on;

const Mesh bar = meshes::bar(2, 2, 8);

std::string shot_text(const std::string& motion = "{0s: 0deg, 1s: 40deg}") {
  return held_bar + "  tip: {select: {axis: z, above: 100%}, rotate: {axis: x, keys: " + motion +
         "}}\nfps: 8\n";
}

class State : public test::StateFolder {
 protected:
  struct Found {
    int frames = 0;
    std::string fault;
  };

  /// What a shot finds of the state.
  Found found(const std::string& text, const Mesh& mesh = bar, const std::string& program = "test") const {
    const Shot shot = shot_of(text);
    const Scene scene = bind_shot(shot, mesh);
    const TakeState state(folder(), {shot, scene}, program);
    return {state.frames(), state.fault()};
  }
  void solve(const std::string& text, int frames = 1000) const {
    const Shot shot = shot_of(text);
    const Scene scene = bind_shot(shot, bar);
    TakeState state(folder(), {shot, scene}, "test");
    solve_on({shot, scene}, bar, state, frames);
  }
  /// That the shot is solved to its known end from whatever is there.
  void expect_whole(const std::string& text) const {
    const Shot shot = shot_of(text);
    const Scene scene = bind_shot(shot, bar);
    TakeState state(folder(), {shot, scene}, "test");
    expect_same(solve_on({shot, scene}, bar, state, 1000), animate(shot, bar, scene));
    const TakeState after(folder(), {shot, scene}, "test");
    EXPECT_TRUE(after.is_complete()) << after.fault();
  }
  void change(const char* name, std::streamoff place, char byte) const {
    std::fstream file(folder() / name, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(place, place < 0 ? std::ios::end : std::ios::beg);
    file.put(byte);
  }
  fs::path frames_file() const { return folder() / "frames"; }
};

TEST_F(State, IsEmptyWhereNothingWasSolved) {
  EXPECT_EQ(found(shot_text()).frames, 0);
  EXPECT_EQ(found(shot_text()).fault, "");
  EXPECT_FALSE(fs::exists(folder())) << "looking makes nothing";
}

TEST_F(State, HoldsFramesAndReportsByNumber) {
  solve(shot_text());
  const Shot shot = shot_of(shot_text());
  const Scene scene = bind_shot(shot, bar);
  const Clip whole = animate(shot, bar, scene);
  const TakeState state(folder(), {shot, scene}, "test");
  ASSERT_EQ(state.frames(), 9);
  EXPECT_TRUE(state.is_complete());
  for (const int k : {8, 0, 3}) {
    EXPECT_EQ(state.positions(k), whole.frames[static_cast<std::size_t>(k)]);
    EXPECT_EQ(state.report(k).solves, whole.reports[static_cast<std::size_t>(k)].solves);
  }
}

TEST_F(State, DoesNotDependOnNamesNorOutputsNorOnHowTheTimelineSaysIt) {
  solve(shot_text());
  for (const std::string& same :
       {shot_text() + "output: other.glb\n", shot_text() + "clips: {a: [0s, 1s]}\n",
        "# a comment\n" + shot_text(), shot_text("{0f: 0rad, 8f: 40deg}"),
        shot_text() + "solver: {preset: quality}\nlambda: {0s: 0.5}\n",
        held_bar + "  renamed: {select: {axis: z, above: 8}, rotate: {axis: x, keys: {0s: 0deg, 1s: "
                   "40deg}}}\nfps: 8\n"}) {
    EXPECT_EQ(found(same).frames, 9) << same;
    EXPECT_EQ(found(same).fault, "");
  }
}

TEST_F(State, IsStaleWhereTheSolverGetsSomethingElse) {
  solve(shot_text());
  const auto fault = [&](const std::string& text) { return found(text).fault; };
  Mesh moved = bar;
  moved.positions(0, 0) += 1e-12;
  EXPECT_EQ(found(shot_text(), moved).fault, "the mesh has changed");
  EXPECT_EQ(found(shot_text(), moved).frames, 0);
  const char* handles = "what the handles and regions hold has changed";
  EXPECT_EQ(fault(shot_text() + "roi: {not: {axis: z, above: 40%, below: 60%}}\n"), handles);
  EXPECT_EQ(fault(shot_text() + "rigid: {r: {axis: z, above: 40%, below: 60%}}\n"), handles);
  EXPECT_EQ(fault(held_bar + "  tip: {select: {axis: z, above: 80%}, rotate: {axis: x, keys: {0s: 0deg, 1s: "
                             "40deg}}}\nfps: 8\n"),
            handles);
  EXPECT_EQ(fault(held_bar + "  tip: {select: {axis: z, above: 100%}, weight: 0.5, rotate: {axis: x, keys: "
                             "{0s: 0deg, 1s: 40deg}}}\nfps: 8\n"),
            handles);
  EXPECT_EQ(
      fault(held_bar + "  tip: {select: {axis: z, above: 100%}, parent: base, rotate: {axis: x, keys: {0s: "
                       "0deg, 1s: 40deg}}}\nfps: 8\n"),
      handles);
  for (const char* solver : {"tolerance: 0.2%", "iterations: 29", "system: direct", "weights: cotangent",
                             "predict: off", "max_step: 20deg", "preset: paper"})
    EXPECT_EQ(fault(shot_text() + "solver: {" + solver + "}\n"), "the solver's settings have changed");
  EXPECT_EQ(found(shot_text(), bar, "another").fault, "another build of flexkey solved it");
  EXPECT_EQ(fault(shot_text() + "lambda: 0.6\n"), "the motion or lambda has changed from frame 0 on");
  EXPECT_EQ(fault(shot_text() + "lambda: {keys: 0.5, regions: [{select: {vertices: [0]}, value: 0.6}]}\n"),
            "the motion or lambda has changed from frame 0 on");
}

TEST_F(State, KeepsTheFramesBeforeAChangeOfTheMotion) {
  const std::string before = shot_text("{0s: 0deg, 0.5s: 20deg, 1s: 40deg}");
  const std::string after = shot_text("{0s: 0deg, 0.5s: 20deg, 1s: 50deg}");
  solve(before, 5);  // up to 0.5 s
  EXPECT_EQ(found(after).frames, 5);
  EXPECT_EQ(found(after).fault, "");
  expect_whole(after);
  EXPECT_EQ(found(before).frames, 5);
  EXPECT_EQ(found(before).fault, "the motion or lambda has changed from frame 5 on");
  expect_whole(before);
}

TEST_F(State, GoesOnWhereTheShotGrewLonger) {
  solve(shot_text());
  EXPECT_EQ(found(shot_text() + "duration: 0.5s\n").frames, 5);
  EXPECT_EQ(found(shot_text() + "duration: 2s\n").frames, 9);
  expect_whole(shot_text() + "duration: 2s\n");
}

TEST_F(State, PassesOverATornTail) {
  solve(shot_text(), 6);
  fs::resize_file(frames_file(), fs::file_size(frames_file()) - 100);
  EXPECT_EQ(found(shot_text()).frames, 5);
  EXPECT_EQ(found(shot_text()).fault, "");
  expect_whole(shot_text());
  std::ofstream(frames_file(), std::ios::app) << "the beginning of a record";
  EXPECT_EQ(found(shot_text()).frames, 9);
}

TEST_F(State, DoesNotTrustDamagedFrames) {
  solve(shot_text());
  const auto size = static_cast<std::streamoff>(fs::file_size(frames_file()));
  change("frames", size - 1000, '\x55');
  EXPECT_EQ(found(shot_text()).frames, 8);
  EXPECT_EQ(found(shot_text()).fault, "frame 8 in it is damaged");
  expect_whole(shot_text());
  change("frames", 30, '\x55');
  EXPECT_EQ(found(shot_text()).fault, "it is damaged or of another format");
  expect_whole(shot_text());
  std::ofstream(frames_file()) << "a text";
  EXPECT_EQ(found(shot_text()).fault, "it is damaged or of another format");
  expect_whole(shot_text());
}

TEST_F(State, LooksAtTheWantedFramesAlone) {
  solve(shot_text());
  const auto size = static_cast<std::streamoff>(fs::file_size(frames_file()));
  change("frames", size - 1000, '\x55');
  const Shot shot = shot_of(shot_text());
  const Scene scene = bind_shot(shot, bar);
  EXPECT_TRUE(TakeState(folder(), {shot, scene}, "test", {0, 7}).is_complete());
  EXPECT_FALSE(TakeState(folder(), {shot, scene}, "test", {0, 8}).is_complete());
}

TEST_F(State, DoesNotTrustADamagedCheckpoint) {
  solve(shot_text(), 4);
  const std::string whole = read_file(folder() / "checkpoint");
  for (const std::size_t place : {std::size_t{3}, std::size_t{200}, whole.size() - 1}) {
    std::string damaged = whole;
    damaged[place] = static_cast<char>(damaged[place] ^ 4);
    std::ofstream(folder() / "checkpoint", std::ios::binary) << damaged;
    EXPECT_EQ(found(shot_text()).fault, "its checkpoint is damaged");
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{10}, whole.size() / 2}) {
    std::ofstream(folder() / "checkpoint", std::ios::binary) << whole.substr(0, size);
    EXPECT_EQ(found(shot_text()).fault, "its checkpoint is damaged");
  }
  expect_whole(shot_text());
}

TEST_F(State, DoesNotGoOnFromACheckpointOfAnotherMotion) {
  const std::string one = shot_text("{0s: 0deg, 1s: 40deg}"), other = shot_text("{0s: 0deg, 1s: 50deg}");
  solve(one, 4);
  const std::string checkpoint = read_file(folder() / "checkpoint");
  solve(other, 5);
  std::ofstream(folder() / "checkpoint", std::ios::binary) << checkpoint;
  expect_whole(other);
}

TEST_F(State, IsClearedOfCheckpointsWhoseWriterWasKilled) {
  solve(shot_text(), 3);
  std::ofstream(folder() / "checkpoint.part-123") << "half of it";
  solve(shot_text());
  EXPECT_FALSE(fs::exists(folder() / "checkpoint.part-123"));
  EXPECT_TRUE(fs::exists(folder() / "checkpoint"));
}

TEST_F(State, ThatIsRemovedIsEmpty) {
  solve(shot_text());
  const Shot shot = shot_of(shot_text());
  const Scene scene = bind_shot(shot, bar);
  TakeState(folder(), {shot, scene}, "test").remove();
  EXPECT_EQ(found(shot_text()).frames, 0);
  EXPECT_TRUE(fs::is_empty(folder()));
}

}  // namespace
}  // namespace flexkey
