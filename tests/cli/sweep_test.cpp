// Whole sweeps over several keys, in parts, and their runs one by one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/work_folder.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey {
namespace {

using nlohmann::json;
using test::ProgramResult;
using testing::ElementsAre;
using testing::HasSubstr;

class SweptShots : public test::WorkFolder {
 protected:
  void SetUp() override {
    WorkFolder::SetUp();
    write("alone.yaml",
          "mesh: bar.obj\nfps: 8\nhandles:\n"
          "  base: {select: {axis: z, below: 1%}}\n"
          "  tip: {select: {axis: z, above: 99%}, rotate: {axis: z, keys: {0s: 0deg, 1s: 90deg}}}\n");
    write("shot.yaml", read_file(folder() / "alone.yaml") +
                           "sweep:\n"
                           "  lambda: [0.2, 0.9]\n"
                           "  handles.tip.rotate.keys.1s: [30deg, 60deg]\n"
                           "output: {cache: '<lambda>_<handles.tip.rotate.keys.1s>.pc2'}\n");
  }
  std::string bytes(const std::string& name) const { return read_file(folder() / name); }
};

TEST_F(SweptShots, EqualSingleRuns) {
  const ProgramResult result = run({"sweep", "shot.yaml", "-d", "out"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(names_in("out"),
              ElementsAre(".flexkey", "0.2_30deg.pc2", "0.2_60deg.pc2", "0.9_30deg.pc2", "0.9_60deg.pc2"));
  EXPECT_THAT(result.errors, HasSubstr("λ = 0.9, handles.tip.rotate.keys.1s = 60deg"));
  for (const std::string lambda : {"0.2", "0.9"})
    for (const std::string angle : {"30deg", "60deg"}) {
      const ProgramResult alone =
          run({"animate", "alone.yaml", "--set", "lambda=" + lambda, "--set",
               "handles.tip.rotate.keys.1s=" + angle, "--set", "output={cache: alone.pc2}"});
      ASSERT_EQ(alone.exit_code, 0) << alone.errors;
      EXPECT_EQ(bytes("alone.pc2"), bytes("out/" + lambda + "_" + angle + ".pc2"));
    }
  EXPECT_NE(bytes("out/0.2_30deg.pc2"), bytes("out/0.9_30deg.pc2"));
}

TEST_F(SweptShots, AreWrittenInPartsOneByOne) {
  ASSERT_EQ(run({"sweep", "shot.yaml", "-d", "whole"}).exit_code, 0);
  for (const std::string chunk : {"1/3", "2/3", "3/3"})
    ASSERT_EQ(run({"sweep", "shot.yaml", "-d", "parts", "--chunk", chunk}).exit_code, 0);
  ASSERT_EQ(names_in("parts"), names_in("whole"));
  for (const std::string& name : names_in("whole"))
    EXPECT_TRUE(name == ".flexkey" || bytes("parts/" + name) == bytes("whole/" + name)) << name;
}

TEST_F(SweptShots, APartMakesNoOtherFile) {
  ASSERT_EQ(run({"sweep", "shot.yaml", "-d", "out", "--chunk", "1/4"}).exit_code, 0);
  EXPECT_THAT(names_in("out"), ElementsAre(".flexkey", "0.2_30deg.pc2"));
  EXPECT_THAT(run({"sweep", "shot.yaml", "--chunk", "1/9"}).errors,
              HasSubstr("--chunk 1/9: there is no run in it; there are 4"));
  for (const std::string chunk : {"0/4", "5/4", "x", "1/", "1"})
    EXPECT_EQ(run({"sweep", "shot.yaml", "--chunk", chunk}).exit_code, 2) << chunk;
  EXPECT_THAT(run({"sweep", "alone.yaml"}).errors, HasSubstr("alone.yaml has no 'sweep'"));
}

TEST_F(SweptShots, AreInTheReportWithTheirValues) {
  const ProgramResult result = run({"solve", "shot.yaml", "--json", "-q"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json runs = json::parse(result.output)["runs"];
  ASSERT_EQ(runs.size(), 4u);
  EXPECT_EQ(runs[0]["swept"], json({{"lambda", "0.2"}, {"handles.tip.rotate.keys.1s", "30deg"}}));
  EXPECT_EQ(runs[0]["solved_before"], 0);
  const json again = json::parse(run({"export", "shot.yaml", "--json", "-q", "--no-solve"}).output);
  for (const json& run : again["runs"]) EXPECT_EQ(run["solved_before"], 9);
}

TEST_F(SweptShots, MayHaveOtherMeshesAndLengths) {
  write("long.obj", test::obj_text(meshes::bar(2, 2, 20)));
  const ProgramResult result =
      run({"animate", "alone.yaml", "--json", "-q", "--set", "sweep={mesh: [bar.obj, long.obj], fps: [4, 8]}",
           "--set", "output={cache: a_<run>.pc2}"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json runs = json::parse(result.output)["runs"];
  ASSERT_EQ(runs.size(), 4u);
  EXPECT_EQ(runs[0]["frames"], 5);
  EXPECT_EQ(runs[1]["frames"], 9);
  EXPECT_EQ(runs[3]["mesh"]["file"], "long.obj");
}

TEST_F(SweptShots, AreCheckedBeforeTheFirstIsSolved) {
  const ProgramResult result = run({"animate", "alone.yaml", "--set", "sweep={mesh: [bar.obj, none.obj]}",
                                    "--set", "output={cache: a_<run>.pc2}"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.errors, HasSubstr("none.obj"));
  EXPECT_THAT(names_in("."), ElementsAre("alone.yaml", "bar.obj", "shot.yaml"));
}

}  // namespace
}  // namespace flexkey
