// A shot that is watched while it is edited.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "cli/file_watch.h"
#include "cli/work_folder.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Watch : public WorkFolder {
 protected:
  void SetUp() override {
    WorkFolder::SetUp();
    write("shot.yaml", shot("0.5"));
  }
  void TearDown() override {
    if (process_ > 0) stop(SIGKILL);
    WorkFolder::TearDown();
  }

  static std::string shot(const std::string& lambda) {
    return fmt::format("{}lambda: {}\n", minimal_shot, lambda);
  }

  void start(const std::string& timeline = "shot.yaml") {
    process_ = fork();
    if (process_ > 0) return;
    fs::current_path(folder());
    const int said = open("said", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    dup2(said, STDERR_FILENO);
    dup2(said, STDOUT_FILENO);
    execl(FLEXKEY_PROGRAM, "flexkey", "watch", timeline.c_str(), "-d", "out", "--frames", "0-3", nullptr);
    _exit(127);
  }
  /// Sends a signal and returns the exit code.
  int stop(int signal) {
    kill(process_, signal);
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  std::string said() const { return fs::exists(folder() / "said") ? read_file(folder() / "said") : ""; }

  /// Waits until it has said a text so often, at most a minute.
  void expect_said(const std::string& text, int times = 1) const {
    for (int tenth = 0; tenth < 600 && count(text) < times; ++tenth)
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_GE(count(text), times) << text << " in:\n" << said();
  }
  int count(const std::string& text) const {
    const std::string all = said();
    int times = 0;
    for (std::size_t at = all.find(text); at != std::string::npos; at = all.find(text, at + 1)) ++times;
    return times;
  }
  /// As many editors save: a new file is renamed over the old one.
  void save(const std::string& name, const std::string& text) const {
    write("new~", text);
    fs::rename(folder() / "new~", folder() / name);
  }

 private:
  pid_t process_ = 0;
};

TEST_F(Watch, MakesTheShotAgainAfterEachSave) {
  start();
  expect_said("wrote out/bar.glb");
  const std::string before = read_file(folder() / "out/bar.glb");
  write("shot.yaml", shot("1"));
  expect_said("shot.yaml saved: solved 4 frames");
  expect_said("wrote out/bar.glb", 2);
  EXPECT_NE(read_file(folder() / "out/bar.glb"), before);
  save("shot.yaml", shot("0.5"));
  expect_said("wrote out/bar.glb", 3);
  EXPECT_EQ(read_file(folder() / "out/bar.glb"), before);
  EXPECT_EQ(stop(SIGINT), 130);
}

TEST_F(Watch, SolvesNothingWhereNothingThatIsSolvedChanged) {
  start();
  expect_said("wrote out/bar.glb");
  write("shot.yaml", "# a comment\n" + shot("0.5"));
  expect_said("shot.yaml saved: nothing to solve");
  EXPECT_EQ(stop(SIGTERM), 143);
}

TEST_F(Watch, OutlivesABrokenTimelineAndAMeshThatIsGoneForAWhile) {
  start();
  expect_said("wrote out/bar.glb");
  write("shot.yaml", shot("1.2"));
  expect_said("shot.yaml:8:9: error: lambda 1.2 is outside");
  expect_said("waiting for the next save");
  fs::rename(folder() / "bar.obj", folder() / "gone.obj");
  write("shot.yaml", shot("0.7"));
  expect_said("waiting for the next save", 2);
  fs::rename(folder() / "gone.obj", folder() / "bar.obj");
  expect_said("bar.obj saved: solved 4 frames");
  expect_said("wrote out/bar.glb", 2);
  EXPECT_EQ(stop(SIGINT), 130);
}

TEST_F(Watch, StartsWithATimelineThatIsNotThereYet) {
  start("later.yaml");
  expect_said("waiting for the next save");
  save("later.yaml", shot("0.5"));
  expect_said("later.yaml saved: solved 4 frames");
  EXPECT_EQ(stop(SIGINT), 130);
}

TEST_F(Watch, SeesTheFilesThatATimelineNames) {
  const auto table = [](double turn) { return fmt::format("time,rz\n0,0\n1,{}\n", turn); };
  write("turn.csv", table(30));
  write("shot.yaml",
        "mesh: bar.obj\nhandles:\n  base: {select: {axis: z, below: 1%}}\n"
        "  tip: {select: {axis: z, above: 99%}, motion: {csv: turn.csv}}\noutput: bar.glb\n");
  start();
  expect_said("wrote out/bar.glb");
  save("turn.csv", table(60));
  expect_said("turn.csv saved: solved");
  save("bar.obj", obj_text(meshes::bar(2, 2, 8)));
  expect_said("bar.obj saved: solved 4 frames");
  EXPECT_EQ(stop(SIGINT), 130);
}

TEST_F(Watch, DrawsDraftsFirst) {
  if (FLEXKEY_HAS_PREVIEWS == 0) GTEST_SKIP() << "built without previews";
  start();
  expect_said("solved 4 frames, drew 4 drafts in out/shot");
  EXPECT_THAT(names_in("out/shot"), ElementsAre("0000.png", "0001.png", "0002.png", "0003.png"));
  EXPECT_LT(said().find("drafts"), said().find("wrote"));
  write("shot.yaml", shot("0.9"));
  expect_said("shot.yaml saved: solved 4 frames, drew 3 drafts");
  EXPECT_EQ(stop(SIGINT), 130);
}

TEST_F(Watch, RefusesStandardInput) {
  const ProgramResult result = run({"watch", "-"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("standard input cannot be watched"));
}

class FileWatching : public WorkFolder {};

TEST_F(FileWatching, TellsOfTheFilesThatItFollowsAlone) {
  cli::FileWatch watch;
  watch.follow({folder() / "bar.obj", folder() / "later.yaml"});
  EXPECT_THAT(watch.changed(), IsEmpty());
  write("other.txt", "1");
  EXPECT_THAT(watch.changed(), IsEmpty());
  write("bar.obj", "1");
  EXPECT_THAT(watch.changed(), ElementsAre("bar.obj"));
  fs::rename(folder() / "other.txt", folder() / "later.yaml");
  fs::remove(folder() / "bar.obj");
  EXPECT_THAT(watch.changed(), ElementsAre("bar.obj", "later.yaml"));
  watch.follow({folder() / "other.txt"});
  write("bar.obj", "1");
  EXPECT_THAT(watch.changed(), IsEmpty());
}

TEST_F(FileWatching, FollowsWhatALinkLeadsTo) {
  fs::create_directories(folder() / "far");
  write("far/real.yaml", "1");
  fs::create_symlink("far/real.yaml", folder() / "link.yaml");
  cli::FileWatch watch;
  watch.follow({folder() / "link.yaml"});
  write("far/real.yaml", "2");
  EXPECT_THAT(watch.changed(), ElementsAre("real.yaml"));
}

}  // namespace
}  // namespace flexkey::test
