// Whole runs of shots that are played again and again.
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
using testing::HasSubstr;

class LoopedShots : public test::WorkFolder {
 protected:
  void SetUp() override {
    WorkFolder::SetUp();
    write("shot.yaml",
          "mesh: bar.obj\nfps: 8\nhandles:\n"
          "  base: {select: {axis: z, below: 1%}}\n"
          "  tip:\n"
          "    select: {axis: z, above: 99%}\n"
          "    rotate: {axis: z, keys: {0s: 0deg, 0.5s: 40deg, 1s: 0deg}}\n"
          "output: {cache: bar.pc2, frames: 'f/%d.obj'}\n");
  }
  ProgramResult animate(const std::string& loop, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"animate", "shot.yaml", "--set", "loop=" + loop});
    return run(more);
  }
  /// Without its first line, which says its number.
  std::string frame(int number) const {
    const std::string obj = read_file(folder() / fmt::format("f/{}.obj", number));
    return obj.substr(obj.find('\n'));
  }
  std::size_t frames() const { return names_in("f").size(); }
};

TEST_F(LoopedShots, ACycleHasAFrameFewerAndSaysHowWellItCloses) {
  const ProgramResult result = animate("cycle");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(frames(), 8u);
  EXPECT_THAT(result.errors, HasSubstr("8 frames of"));
  EXPECT_THAT(result.errors, HasSubstr("  loop   ends within "));
  const json report = json::parse(animate("cycle", {"--json", "-q"}).output)["runs"][0];
  EXPECT_EQ(report["frames"], 17);
  EXPECT_EQ(report["frame_reports"][0]["frame"], -8);
  EXPECT_EQ(report["frame_reports"][16]["frame"], 8);
  EXPECT_LT(report["gap"], 2e-3);
}

TEST_F(LoopedShots, PingPongEndsWithItsFirstFrameWithAndWithoutAState) {
  ASSERT_EQ(animate("ping-pong").exit_code, 0);
  EXPECT_EQ(frames(), 17u);
  EXPECT_TRUE(frame(16) == frame(0));
  EXPECT_TRUE(frame(10) == frame(6));
  EXPECT_FALSE(frame(8) == frame(4));
  const std::string cache = read_file(folder() / "bar.pc2");
  fs::remove_all(folder() / ".flexkey");
  write(".flexkey", "in the way of a state");
  ASSERT_EQ(animate("ping-pong").exit_code, 0);
  EXPECT_TRUE(read_file(folder() / "bar.pc2") == cache);
}

TEST_F(LoopedShots, AreExportedFromTheirStateAndByPickedFrames) {
  for (const std::string loop : {"cycle", "ping-pong"}) {
    SCOPED_TRACE(loop);
    ASSERT_EQ(run({"solve", "shot.yaml", "--set", "loop=" + loop}).exit_code, 0);
    ASSERT_EQ(run({"export", "shot.yaml", "--set", "loop=" + loop, "--no-solve"}).exit_code, 0);
    const std::string last = frame(7);
    fs::remove_all(folder() / "f");
    ASSERT_EQ(animate(loop, {"--frames", "7", "-d", "other"}).exit_code, 0);
    const std::string alone = read_file(folder() / "other/f/7.obj");
    EXPECT_TRUE(alone.substr(alone.find('\n')) == last);
    fs::remove_all(folder() / "f");
  }
}

TEST_F(LoopedShots, GiveAPageAndAGlbWithHandlesAndClips) {
  for (const std::string loop : {"cycle", "ping-pong"}) {
    const ProgramResult result =
        animate(loop, {"--set", "output={gltf: {path: b.glb, handles: true}, html: b.html}", "--set",
                       "clips={all: [0s, 1s]}"});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
  }
}

}  // namespace
}  // namespace flexkey
