// The program as a newcomer meets it: no arguments, a typo, no file, a broken mesh, an interrupt.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "cli/run_program.h"
#include "cli/work_folder.h"
#include "flexkey/deform/cholesky.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey {
namespace {

namespace fs = std::filesystem;
using test::ProgramResult;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Program : public test::WorkFolder {};

TEST_F(Program, HelpNamesCommandsAndExitCodes) {
  const ProgramResult result = run({"--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, HasSubstr("animate"));
  EXPECT_THAT(result.output, HasSubstr("did not converge"));
  EXPECT_THAT(run({"animate", "--help"}).output, HasSubstr("flexkey animate timelines/nose.yaml -d out"));
}

TEST_F(Program, VersionSaysWhatIsLeftOut) {
  const std::string version = run({"--version"}).output;
  EXPECT_THAT(version, StartsWith("flexkey "));
  EXPECT_THAT(version, HasSubstr("factors with " + factoring_library()));
  EXPECT_THAT(version, HasSubstr(FLEXKEY_HAS_PREVIEWS ? "draws previews" : "built without previews"));
}

TEST_F(Program, WrongUsageExitsTwo) {
  EXPECT_EQ(run({}).exit_code, 2);
  EXPECT_EQ(run({"anmate"}).exit_code, 2);
  EXPECT_EQ(run({"animate"}).exit_code, 2);
  EXPECT_EQ(run({"animate", "x.yaml", "--threads", "-1"}).exit_code, 2);
  write("shot.yaml", test::minimal_shot);
  EXPECT_EQ(run({"animate", "shot.yaml", "--frames", "0-900"}).exit_code, 2);
  EXPECT_EQ(run({"animate", "shot.yaml", "--set", "lambda"}).exit_code, 2);
}

TEST_F(Program, AMissingTimelineExitsTwoAMissingMeshThree) {
  const ProgramResult no_timeline = run({"animate", "none.yaml"});
  EXPECT_EQ(no_timeline.exit_code, 2);
  EXPECT_THAT(no_timeline.errors, HasSubstr("none.yaml"));
  write("shot.yaml", test::minimal_shot);
  fs::remove(folder() / "bar.obj");
  const ProgramResult no_mesh = run({"animate", "shot.yaml"});
  EXPECT_EQ(no_mesh.exit_code, 3);
  EXPECT_THAT(no_mesh.errors, HasSubstr("shot.yaml:1:7: cannot read 'bar.obj': No such file or directory"));
}

TEST_F(Program, ThreeMistakesAreThreeErrorsWithTheirPlaces) {
  write("shot.yaml",
        "mesh: bar.obj\n"
        "handles:\n"
        "  base: {select: {axis: z, below: 1%}}\n"
        "  tip:\n"
        "    select: {axis: z, above: 99%}\n"
        "    rotat: {axis: z, keys: {0s: 0deg, 1s: 90deg}}\n"
        "lambda: 1.2\n"
        "fps: fast\n"
        "output: bar.glb\n");
  const ProgramResult result = run({"animate", "shot.yaml"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(
      result.errors,
      HasSubstr("shot.yaml:6:5: error: unknown key 'rotat' in handle 'tip'; did you mean 'rotate'?\n"));
  EXPECT_THAT(result.errors,
              HasSubstr("shot.yaml:7:9: error: lambda 1.2 is outside 0..1 (0 smooth, 1 most rigid)\n"));
  EXPECT_THAT(result.errors, HasSubstr("shot.yaml:8:6: error: "));
  EXPECT_FALSE(fs::exists(folder() / "bar.glb"));
}

TEST_F(Program, ABrokenMeshExitsThreeWithItsPlace) {
  write("shot.yaml", test::minimal_shot);
  write("bar.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n");
  const ProgramResult result = run({"animate", "shot.yaml"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.errors, HasSubstr("bar.obj:3: face 0 uses vertex index 9"));
}

TEST_F(Program, AnUnwritableOutputExitsFiveBeforeSolving) {
  write("shot.yaml", test::minimal_shot);
  write("file", "not a folder");
  const ProgramResult result = run({"animate", "shot.yaml", "-d", "file"});
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_THAT(result.errors, HasSubstr("Not a directory"));
  EXPECT_THAT(result.errors, Not(HasSubstr("Progress")));
}

TEST_F(Program, AFullDiskExitsFive) {
  write("shot.yaml", test::minimal_shot);
  const ProgramResult result = run({"animate", "shot.yaml", "--set", "output=/dev/full"});
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_THAT(result.errors, HasSubstr("No space left on device"));
}

TEST_F(Program, NeverWritesOverAnInput) {
  write("shot.yaml", test::minimal_shot);
  for (const char* output : {"output=bar.obj", "output=./shot.yaml"})
    EXPECT_EQ(run({"animate", "shot.yaml", "--set", output}).exit_code, 2) << output;
  EXPECT_THAT(read_file(folder() / "bar.obj"), StartsWith("v "));
}

TEST_F(Program, NeverWritesOverWhatTheMeshRefersTo) {
  write("shot.yaml", test::minimal_shot);
  write("bar.mtl", "newmtl red\nKd 1 0 0\n");
  write("bar.obj", "mtllib bar.mtl\n" + read_file(folder() / "bar.obj"));
  EXPECT_EQ(run({"animate", "shot.yaml", "--set", "output=bar.mtl"}).exit_code, 2);
  fs::create_symlink("bar.mtl", folder() / "link.glb");
  const ProgramResult result = run({"animate", "shot.yaml", "--set", "output=link.glb"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors,
              HasSubstr("--set output: error: the output './link.glb' would replace an input"));
  EXPECT_THAT(read_file(folder() / "bar.mtl"), HasSubstr("newmtl red"));
}

TEST_F(Program, AnotherFileNameThanAGlbIsRefusedWithItsPlace) {
  write("shot.yaml", test::minimal_shot);
  for (const char* output : {"output=a.gltf", "output=a", "output=folder/", "output=."})
    for (const char* command : {"animate", "check"}) {
      const ProgramResult result = run({command, "shot.yaml", "--set", output});
      EXPECT_EQ(result.exit_code, 2) << output;
      EXPECT_THAT(result.errors, HasSubstr("--set output: error: the output"));
    }
  EXPECT_FALSE(fs::exists(folder() / "folder"));
}

TEST_F(Program, ALostReportExitsFiveAndLostMessagesDoNotMatter) {
  write("shot.yaml", test::minimal_shot);
  EXPECT_EQ(run({"check", "shot.yaml", "--json"}, {}, {}, ">/dev/full").exit_code, 5);
  EXPECT_EQ(run({"--version"}, {}, {}, ">/dev/full").exit_code, 5);
  EXPECT_EQ(run({"animate", "shot.yaml"}, {}, {}, "2>/dev/full").exit_code, 0);
  EXPECT_EQ(run({"animate", "none.yaml"}, {}, {}, "2>/dev/full").exit_code, 2);
  EXPECT_EQ(run({"animate", "shot.yaml"}, {}, {}, "2>&-").exit_code, 0);
}

TEST_F(Program, AFileSizeLimitExitsFiveAndLeavesNothing) {
  write("shot.yaml", test::minimal_shot);
  const ProgramResult result = run({"animate", "shot.yaml", "-d", "out"}, {}, "ulimit -f 20;");
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_THAT(result.errors, HasSubstr("warning: cannot write 'out/.flexkey/shot/frames'"))
      << "nor the state";
  EXPECT_THAT(result.errors, HasSubstr("File too large"));
  EXPECT_THAT(names_in("out"), testing::ElementsAre(".flexkey"));
  EXPECT_THAT(names_in("out/.flexkey/shot"), testing::ElementsAre("lock"));
}

TEST_F(Program, AMeshThatCannotBeLookedAtExitsThree) {
  write("shot.yaml", test::minimal_shot);
  fs::remove(folder() / "bar.obj");
  fs::create_symlink("bar.obj", folder() / "bar.obj");
  EXPECT_EQ(run({"animate", "shot.yaml"}).exit_code, 3);
  EXPECT_EQ(run({"animate", "shot.yaml", "--set", "mesh=" + std::string(300, 'x') + ".obj"}).exit_code, 3);
}

TEST_F(Program, AnUnknownCommandIsNamed) {
  EXPECT_EQ(run({"anmate", "shot.yaml"}).errors,
            "flexkey: error: unknown command 'anmate'; did you mean 'animate'?\n");
  EXPECT_EQ(run({"anmate", "shot.yaml"}).exit_code, 2);
}

TEST_F(Program, AnInterruptLeavesNoHalfFile) {
  write("bar.obj", test::obj_text(meshes::bar(10, 10, 40)));
  write("shot.yaml", std::string(test::minimal_shot) +
                         "fps: 100\nsolver: {accelerate: off, iterations: 300, tolerance: 0.0000000001%}\n");
  const ProgramResult result =
      run({"animate", "shot.yaml", "-d", "out"}, {}, "timeout --foreground --preserve-status -s INT 0.4");
  EXPECT_EQ(result.exit_code, 130);
  EXPECT_THAT(result.errors, HasSubstr("stopped by a signal after"));
  EXPECT_THAT(names_in("out"), testing::ElementsAre(".flexkey"));
}

}  // namespace
}  // namespace flexkey
