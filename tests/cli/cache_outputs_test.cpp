// Whole runs that write vertex caches, sequences and USD.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/work_folder.h"
#include "flexkey/mesh/obj.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::ProgramResult;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Caches : public test::WorkFolder {
 protected:
  void SetUp() override {
    WorkFolder::SetUp();
    write("shot.yaml", test::minimal_shot);
  }

  /// Runs a command on a shot with this output instead of its GLB.
  ProgramResult run_with(const std::string& output, std::vector<std::string> arguments = {},
                         const std::string& wrapper = {}) const {
    arguments.insert(arguments.begin(), {"animate", "shot.yaml", "--set", "output=" + output});
    return run(arguments, {}, wrapper);
  }
  std::uintmax_t size_of(const std::string& name) const { return fs::file_size(folder() / name); }
  bool exists(const std::string& name) const { return fs::exists(folder() / name); }
  std::ptrdiff_t files_in(const std::string& name) const {
    const fs::directory_iterator files(folder() / name);
    return std::distance(begin(files), end(files));
  }
  int vertices() const { return read_obj(folder() / "bar.obj").mesh.vertex_count(); }
};

TEST_F(Caches, OfAllFormsAreWrittenBesideTheGlb) {
  const ProgramResult result = run_with(
      "{gltf: bar.glb, cache: [bar.pc2, {path: bar.mdd}], frames: ['f/%04d.obj', 'f/%04d.npz'], usd: "
      "bar.usda}");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.output, "./bar.glb\n./bar.pc2\n./bar.mdd\n./f/%04d.obj\n./f/%04d.npz\n./bar.usda\n");
  const auto frame = static_cast<std::uintmax_t>(vertices() * 12);
  EXPECT_EQ(size_of("bar.pc2"), 32 + 25 * frame);
  EXPECT_EQ(size_of("bar.mdd"), 8 + 25 * 4 + 25 * frame);
  EXPECT_EQ(files_in("f"), 50);
  EXPECT_TRUE(exists("f/0000.npz") && exists("f/0024.obj"));
  EXPECT_THAT(read_file(folder() / "bar.usda"), StartsWith("#usda 1.0\n"));
  EXPECT_THAT(result.errors, HasSubstr("./f/%04d.obj, 25 files, "));
}

TEST_F(Caches, NeedNoGlbAndGiveItsBytesNoOtherTurn) {
  const ProgramResult alone = run_with("{cache: a.pc2}");
  ASSERT_EQ(alone.exit_code, 0) << alone.errors;
  EXPECT_FALSE(exists("bar.glb"));
  ASSERT_EQ(run_with("{cache: b.pc2, gltf: b.glb}").exit_code, 0);
  ASSERT_EQ(run_with("{gltf: c.glb}").exit_code, 0);
  EXPECT_EQ(read_file(folder() / "a.pc2"), read_file(folder() / "b.pc2"));
  EXPECT_EQ(size_of("b.glb"), size_of("c.glb"));
}

TEST_F(Caches, AreInTheReportWithTheirBytes) {
  const ProgramResult result = run_with("{cache: a.mdd, frames: 'f/%d.npz'}", {"--json", "-q"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json outputs = json::parse(result.output)["runs"][0]["outputs"];
  ASSERT_EQ(outputs.size(), 2u);
  EXPECT_EQ(outputs[0]["path"], "./a.mdd");
  EXPECT_EQ(outputs[0]["format"], "mdd");
  EXPECT_EQ(outputs[0]["files"], 1);
  EXPECT_EQ(outputs[0]["bytes"], size_of("a.mdd"));
  EXPECT_EQ(outputs[1]["path"], "./f/%d.npz");
  EXPECT_EQ(outputs[1]["files"], 25);
  EXPECT_EQ(outputs[1]["bytes"], 25 * size_of("f/0.npz"));
}

TEST_F(Caches, HoldThePickedFramesUnderTheirNumbers) {
  const ProgramResult result = run_with("{cache: a.pc2, frames: 'f/%04d.obj'}", {"--frames", "6-18x6"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(size_of("a.pc2"), static_cast<std::uintmax_t>(32 + 3 * vertices() * 12));
  EXPECT_EQ(files_in("f"), 3);
  EXPECT_TRUE(exists("f/0006.obj") && exists("f/0012.obj") && exists("f/0018.obj"));
}

TEST_F(Caches, APc2OfUnevenFramesIsRefusedWithItsPlace) {
  const ProgramResult result = run_with("{cache: a.pc2}", {"--frames", "0-5,9"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("--set output: error: the frames of 'a.pc2' must be evenly spaced"));
  EXPECT_EQ(run_with("{cache: a.mdd}", {"--frames", "0-5,9"}).exit_code, 0);
}

TEST_F(Caches, OfASweepAreOneARun) {
  const ProgramResult result = run_with("{cache: a_<lambda>.pc2, frames: '<lambda>/%d.obj'}",
                                        {"--set", "sweep={lambda: [0, 0.5, 1]}"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(exists("a_0.pc2") && exists("a_0.5.pc2") && exists("a_1.pc2"));
  EXPECT_EQ(files_in("0"), 25);
  EXPECT_THAT(read_file(folder() / "0.5/3.obj"), StartsWith("# frame 3, lambda 0.5\n"));
  EXPECT_NE(read_file(folder() / "0/12.obj"), read_file(folder() / "1/12.obj"));
}

TEST_F(Caches, NeverReplaceAnInput) {
  fs::copy(folder() / "bar.obj", folder() / "0003.obj");
  const std::string before = read_file(folder() / "0003.obj");
  for (const char* command : {"animate", "check"}) {
    const ProgramResult result =
        run({command, "shot.yaml", "--set", "mesh=0003.obj", "--set", "output={frames: '%04d.obj'}"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, HasSubstr("the output './0003.obj' would replace an input"));
  }
  EXPECT_EQ(read_file(folder() / "0003.obj"), before);
  EXPECT_FALSE(exists("0000.obj"));
}

TEST_F(Caches, NamedTwiceAreRefused) {
  for (const char* output : {"{cache: [a.pc2, ./a.pc2]}", "{frames: ['f/%d.obj', 'g/../f/%01d.obj']}"}) {
    const ProgramResult result = run_with(output);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, HasSubstr("is named twice")) << output;
  }
}

TEST_F(Caches, OnAFullDiskExitFive) {
  for (const char* name : {"a.pc2", "a.mdd", "a.usda"}) {
    fs::create_symlink("/dev/full", folder() / name);
    const char* key = std::string_view(name) == "a.usda" ? "usd" : "cache";
    const ProgramResult result = run_with(fmt::format("{{{}: {}}}", key, name));
    EXPECT_EQ(result.exit_code, 5);
    EXPECT_THAT(result.errors, HasSubstr(fmt::format("cannot write './{}': No space left", name)));
  }
}

TEST_F(Caches, OverAFileSizeLimitExitFiveAndLeaveNoHalfFile) {
  for (const char* output : {"{cache: out/a.pc2}", "{usd: out/a.usda}", "{frames: 'out/%d.obj'}"}) {
    fs::create_directory(folder() / "out");
    const ProgramResult result = run_with(output, {}, "ulimit -f 4;");
    EXPECT_EQ(result.exit_code, 5) << output;
    EXPECT_THAT(result.errors, HasSubstr("File too large")) << output;
    EXPECT_TRUE(fs::is_empty(folder() / "out")) << output;
    fs::remove_all(folder() / "out");
  }
}

TEST_F(Caches, ThatCannotBeWrittenExitFiveBeforeSolving) {
  write("file", "not a folder");
  for (const char* output : {"{cache: file/a.pc2}", "{frames: 'file/%d.npz'}"}) {
    const ProgramResult result = run_with(output);
    EXPECT_EQ(result.exit_code, 5);
    EXPECT_THAT(result.errors, HasSubstr("Not a directory"));
    EXPECT_THAT(result.errors, Not(HasSubstr("Progress")));
  }
}

/// Runs a program and interrupts it once it has written its second frame.
constexpr const char* interrupting =
    "sh -c '\"$@\" & while kill -0 $! && [ ! -e out/f/0001.obj ]; do sleep 0.02; done; kill -INT $!; wait "
    "$!' sh";

TEST_F(Caches, AnInterruptKeepsWholeFramesAndNoHalfCache) {
  write("bar.obj", test::obj_text(meshes::bar(10, 10, 40)));
  write("shot.yaml", std::string(test::minimal_shot) +
                         "fps: 100\nsolver: {accelerate: off, iterations: 300, tolerance: 0.0000000001%}\n");
  const ProgramResult result =
      run_with("{cache: out/a.pc2, usd: out/a.usda, frames: 'out/f/%04d.obj'}", {}, interrupting);
  EXPECT_EQ(result.exit_code, 130);
  EXPECT_THAT(result.errors, HasSubstr("'./out/a.pc2' was not written"));
  const std::ptrdiff_t frames = files_in("out/f");
  EXPECT_THAT(result.errors, HasSubstr(fmt::format("'./out/f/%04d.obj' has {} frames", frames)));
  EXPECT_EQ(files_in("out"), 1) << "the folder of the frames alone";
  EXPECT_GT(frames, 1);
  EXPECT_LT(frames, 101);
  for (std::ptrdiff_t k = 0; k < frames; ++k)
    EXPECT_EQ(read_obj(folder() / fmt::format("out/f/{:04}.obj", k)).mesh.vertex_count(), vertices());
}

TEST_F(Caches, CheckListsThem) {
  const ProgramResult result =
      run({"check", "shot.yaml", "--json", "--set", "output={cache: a.pc2, usd: a.usda}"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(json::parse(result.output)["outputs"], json::array({"a.pc2", "a.usda"}));
}

}  // namespace
}  // namespace flexkey
