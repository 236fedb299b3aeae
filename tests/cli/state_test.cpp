// A shot's state between commands: what goes on, what is stale, what cannot be kept.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/work_folder.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::ProgramResult;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class ShotState : public test::WorkFolder {
 protected:
  void SetUp() override {
    WorkFolder::SetUp();
    write("shot.yaml", test::minimal_shot);
  }
  ProgramResult run_wrapped(const std::string& wrapper, const std::vector<std::string>& arguments) const {
    return run(arguments, {}, wrapper);
  }
  std::string bytes(const std::string& name) const { return read_file(folder() / name); }
  std::size_t solved_before(const std::string& report) const {
    return json::parse(report)["runs"][0]["solved_before"];
  }
  void change(const std::string& name, std::streamoff place) const {
    std::fstream file(folder() / name, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(place);
    file.put('\x55');
  }

  const std::string state_ = ".flexkey/shot/";
};

TEST_F(ShotState, IsSolvedOnceForEveryOutput) {
  const ProgramResult solved = run({"solve", "shot.yaml"});
  ASSERT_EQ(solved.exit_code, 0) << solved.errors;
  EXPECT_EQ(solved.output, "./.flexkey/shot\n");
  EXPECT_FALSE(fs::exists(folder() / "bar.glb"));
  const ProgramResult exported = run({"export", "shot.yaml", "--no-solve"});
  ASSERT_EQ(exported.exit_code, 0) << exported.errors;
  EXPECT_THAT(exported.errors, HasSubstr("solved before; "));
  const std::string glb = bytes("bar.glb");
  EXPECT_EQ(solved_before(run({"animate", "shot.yaml", "--json", "-q"}).output), 25u);
  EXPECT_EQ(bytes("bar.glb"), glb);
  ASSERT_EQ(run({"animate", "shot.yaml", "-d", "other"}).exit_code, 0);
  EXPECT_EQ(bytes("other/bar.glb"), glb) << "as solved at once";
  const ProgramResult other =
      run({"export", "shot.yaml", "--no-solve", "--set", "output={cache: a.mdd, html: a.html}"});
  EXPECT_EQ(other.exit_code, 0) << other.errors;
  EXPECT_TRUE(fs::exists(folder() / "a.mdd") && fs::exists(folder() / "a.html"));
}

TEST_F(ShotState, IsMissedByItsPlaceOnlyWhereNothingMayBeSolved) {
  const ProgramResult missing = run({"export", "shot.yaml", "--no-solve"});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.errors,
              HasSubstr("flexkey: error: there is no state in './.flexkey/shot'; solve it first"));
  EXPECT_FALSE(fs::exists(folder() / ".flexkey"));
  ASSERT_EQ(run({"animate", "shot.yaml", "--frames", "0-9"}).exit_code, 0);
  const ProgramResult partial = run({"export", "shot.yaml", "--no-solve"});
  EXPECT_EQ(partial.exit_code, 2);
  EXPECT_THAT(partial.errors, HasSubstr("the state in './.flexkey/shot' has 10 of 25 frames"));
  EXPECT_EQ(run({"export", "shot.yaml", "--no-solve", "--frames", "3-9x3"}).exit_code, 0);
  const ProgramResult rest = run({"export", "shot.yaml", "--json"});
  EXPECT_EQ(rest.exit_code, 0);
  EXPECT_THAT(rest.errors, HasSubstr("note: going on from frame 10 by the state in './.flexkey/shot'"));
  EXPECT_EQ(solved_before(rest.output), 10u);
}

TEST_F(ShotState, IsStaleByWhatTheSolverGets) {
  ASSERT_EQ(run({"solve", "shot.yaml"}).exit_code, 0);
  const auto refusal = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"export", "shot.yaml", "--no-solve"});
    const ProgramResult result = run(more);
    EXPECT_EQ(result.exit_code, 2);
    return result.errors;
  };
  EXPECT_THAT(refusal({"--set", "lambda=0.1"}),
              HasSubstr("is stale: the motion or lambda has changed from frame 0 on"));
  EXPECT_THAT(refusal({"--set", "solver.tolerance=0.2%"}),
              HasSubstr("is stale: the solver's settings have changed"));
  std::string obj = bytes("bar.obj");
  write("bar.obj", "# a comment more\n" + obj);
  EXPECT_EQ(run({"export", "shot.yaml", "--no-solve"}).exit_code, 0);
  write("bar.obj", obj.insert(obj.find('\n'), "1"));
  EXPECT_THAT(refusal({}), HasSubstr("is stale: the mesh has changed"));
  const ProgramResult again = run({"animate", "shot.yaml", "--json"});
  EXPECT_THAT(again.errors, HasSubstr("note: the state in './.flexkey/shot' does not serve: the mesh has "
                                      "changed; solving from frame 0\n"));
  EXPECT_EQ(solved_before(again.output), 0u);
  EXPECT_EQ(solved_before(run({"animate", "shot.yaml", "--json", "-q"}).output), 25u);
}

TEST_F(ShotState, ThatIsDamagedIsSolvedAnew) {
  ASSERT_EQ(run({"animate", "shot.yaml"}).exit_code, 0);
  const std::string glb = bytes("bar.glb");
  const auto size = static_cast<std::streamoff>(fs::file_size(folder() / (state_ + "frames")));
  for (const std::streamoff place : {std::streamoff{5}, size / 2, size - 10}) {
    change(state_ + "frames", place);
    EXPECT_EQ(run({"export", "shot.yaml", "--no-solve"}).exit_code, 2);
    const ProgramResult result = run({"animate", "shot.yaml"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.errors, HasSubstr("damaged"));
    EXPECT_EQ(bytes("bar.glb"), glb);
  }
}

TEST_F(ShotState, OfASweepIsOneARun) {
  const std::vector<std::string> sweep{"--set", "sweep={lambda: [0, 0.5, 1]}", "--set",
                                       "output=<lambda>.glb"};
  std::vector<std::string> solve{"solve", "shot.yaml"}, animate{"animate", "shot.yaml", "--json", "-q"};
  solve.insert(solve.end(), sweep.begin(), sweep.end());
  animate.insert(animate.end(), sweep.begin(), sweep.end());
  ASSERT_EQ(run(solve).exit_code, 0);
  EXPECT_THAT(names_in(state_), ElementsAre("lambda-0", "lambda-0.5", "lambda-1"));
  fs::remove_all(folder() / (state_ + "lambda-0.5"));
  const json runs = json::parse(run(animate).output)["runs"];
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_EQ(runs[0]["solved_before"], 25);
  EXPECT_EQ(runs[1]["solved_before"], 0);
  EXPECT_EQ(runs[2]["solved_before"], 25);
  ASSERT_EQ(run({"animate", "shot.yaml", "--set", "lambda=0.5", "--set", "output=alone.glb"}).exit_code, 0);
  EXPECT_EQ(fs::file_size(folder() / "alone.glb"), fs::file_size(folder() / "0.5.glb"));
}

TEST_F(ShotState, ThatCannotBeKeptIsAWarningForAnimateAndAnErrorForSolve) {
  write(".flexkey", "not a folder");
  const ProgramResult animated = run({"animate", "shot.yaml"});
  EXPECT_EQ(animated.exit_code, 0);
  EXPECT_THAT(animated.errors,
              HasSubstr("warning: cannot keep the state in './.flexkey/shot': Not a directory"));
  EXPECT_TRUE(fs::exists(folder() / "bar.glb"));
  const ProgramResult solved = run({"solve", "shot.yaml"});
  EXPECT_EQ(solved.exit_code, 5);
  EXPECT_THAT(solved.errors, HasSubstr("error: cannot keep the state in './.flexkey/shot': Not a directory"));
  EXPECT_THAT(solved.errors, Not(HasSubstr("Progress")));
}

TEST_F(ShotState, OnAFullDiskLeavesTheRoomToTheOutputs) {
  fs::create_directories(folder() / state_);
  fs::create_symlink("/dev/full", folder() / (state_ + "frames"));
  const ProgramResult solved = run({"solve", "shot.yaml"});
  EXPECT_EQ(solved.exit_code, 5);
  EXPECT_THAT(solved.errors,
              HasSubstr("error: cannot write './.flexkey/shot/frames': No space left on device"));
  const ProgramResult animated = run({"animate", "shot.yaml"});
  EXPECT_EQ(animated.exit_code, 0);
  EXPECT_THAT(animated.errors, HasSubstr("No space left on device; solving on without a state\n"));
  EXPECT_TRUE(fs::exists(folder() / "bar.glb"));
  EXPECT_THAT(names_in(state_), ElementsAre("lock"));
}

TEST_F(ShotState, ThatDoesNotFitKeepsItsWholeFramesForTheNextSolve) {
  const std::string limit = "ulimit -f 150;";  // 75 kB, of 100 that the frames take
  const ProgramResult solved = run_wrapped(limit, {"solve", "shot.yaml"});
  EXPECT_EQ(solved.exit_code, 5);
  EXPECT_THAT(solved.errors, HasSubstr("File too large"));
  const ProgramResult partial = run({"export", "shot.yaml", "--no-solve"});
  EXPECT_THAT(partial.errors, testing::ContainsRegex("has [1-9][0-9]* of 25 frames"));
  EXPECT_EQ(run({"solve", "shot.yaml"}).exit_code, 0);
  fs::remove_all(folder() / ".flexkey");
  const ProgramResult animated =
      run_wrapped(limit, {"animate", "shot.yaml", "--set", "output={cache: a.pc2}"});
  EXPECT_EQ(animated.exit_code, 0);
  EXPECT_THAT(animated.errors, HasSubstr("File too large; solving on without a state\n"));
  EXPECT_THAT(names_in(state_), ElementsAre("lock"));
}

TEST_F(ShotState, IsNotTouchedWhileAnotherProcessIsAtIt) {
  ASSERT_EQ(run({"solve", "shot.yaml"}).exit_code, 0);
  const std::string frames = bytes(state_ + "frames");
  const std::string writing = "flock .flexkey/shot/lock", reading = "flock -s .flexkey/shot/lock";
  const ProgramResult solved = run_wrapped(writing, {"solve", "shot.yaml"});
  EXPECT_EQ(solved.exit_code, 5);
  EXPECT_THAT(solved.errors,
              HasSubstr("cannot keep the state in './.flexkey/shot': another flexkey is solving it"));
  EXPECT_EQ(run_wrapped(writing, {"export", "shot.yaml", "--no-solve"}).exit_code, 5);
  const ProgramResult animated = run_wrapped(writing, {"animate", "shot.yaml", "--set", "lambda=0.1"});
  EXPECT_EQ(animated.exit_code, 0);
  EXPECT_THAT(animated.errors, HasSubstr("warning: cannot keep the state"));
  EXPECT_EQ(bytes(state_ + "frames"), frames);
  EXPECT_EQ(run_wrapped(reading, {"export", "shot.yaml", "--no-solve"}).exit_code, 0);
  EXPECT_EQ(solved_before(run_wrapped(reading, {"animate", "shot.yaml", "--json", "-q"}).output), 25u);
}

/// Runs the program and sends it a signal once its state has so many bytes of frames and, for one that ends
/// it at once, a checkpoint.
std::string killing(const char* signal, std::uintmax_t bytes) {
  const char* ready = std::string_view(signal) == "KILL" ? "[ -e .flexkey/shot/checkpoint ]" : "true";
  return fmt::format(
      "sh -c '\"$@\" & while kill -0 $! && ! {{ {} && [ $(wc -c <.flexkey/shot/frames || echo 0) -gt {} ]; "
      "}}; "
      "do sleep 0.01; done; kill -{} $!; wait $!' sh",
      ready, bytes, signal);
}

TEST_F(ShotState, OfAStoppedSolveGoesOnToTheSameBytes) {
  write("bar.obj", test::obj_text(meshes::bar(10, 10, 40)));
  write("shot.yaml", std::string(test::minimal_shot) +
                         "fps: 60\nsolver: {accelerate: off, iterations: 300, tolerance: 0.0000000001%}\n");
  ASSERT_EQ(run({"animate", "shot.yaml"}).exit_code, 0);
  const std::string glb = bytes("bar.glb");
  const std::uintmax_t frame = fs::file_size(folder() / (state_ + "frames")) / 61;
  struct Stop {
    const char* signal;
    std::uintmax_t frames;
    int exit_code;
  };
  for (const Stop& stop :
       {Stop{"INT", 1, 130}, Stop{"TERM", 12, 143}, Stop{"KILL", 3, 137}, Stop{"KILL", 30, 137}}) {
    fs::remove_all(folder() / ".flexkey");
    fs::remove(folder() / "bar.glb");
    const std::string command = stop.frames > 10 ? "solve" : "animate";
    const ProgramResult stopped =
        run_wrapped(killing(stop.signal, stop.frames * frame), {command, "shot.yaml"});
    EXPECT_EQ(stopped.exit_code, stop.exit_code) << stopped.errors;
    EXPECT_FALSE(fs::exists(folder() / "bar.glb"));
    const bool says_so = stopped.errors.find("the same command goes on from there") != std::string::npos;
    EXPECT_EQ(says_so, stop.exit_code != 137);
    const ProgramResult gone_on = run({"animate", "shot.yaml", "--json"});
    ASSERT_EQ(gone_on.exit_code, 0) << gone_on.errors;
    EXPECT_THAT(gone_on.errors, HasSubstr("note: going on from frame "));
    EXPECT_GT(solved_before(gone_on.output), 0u);
    EXPECT_LT(solved_before(gone_on.output), 61u);
    EXPECT_EQ(bytes("bar.glb"), glb) << stop.signal;
  }
}

}  // namespace
}  // namespace flexkey
