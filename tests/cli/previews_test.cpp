// Whole runs that draw pictures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/work_folder.h"
#include "flexkey/mesh/read_file.h"
#include "flexkey/preview/images/image_file.h"
#include "flexkey/preview/images/sheet.h"

namespace flexkey {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::ProgramResult;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

/// Small and quick.
constexpr const char* small = "size: [64, 36], quality: draft, subdivide: 0";

class PreviewsOf : public test::WorkFolder {
 protected:
  void SetUp() override {
    WorkFolder::SetUp();
    setenv("FLEXKEY_MODULES", fs::path(FLEXKEY_PROGRAM).parent_path().c_str(), 1);
    write("shot.yaml", test::minimal_shot);
  }

  /// Runs `animate` on the shot with these keys of output.preview beside the small ones.
  ProgramResult run_with(const std::string& keys, std::vector<std::string> arguments = {},
                         const std::string& wrapper = {}) const {
    const std::string output = fmt::format("output={{preview: {{{}, {}}}}}", small, keys);
    arguments.insert(arguments.begin(), {"animate", "shot.yaml", "--set", output});
    return run(arguments, {}, wrapper);
  }
  bool exists(const std::string& name) const { return fs::exists(folder() / name); }
  /// Names of what lies in a folder, sorted.
  std::vector<std::string> names_in(const std::string& name) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder() / name))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }
  std::string bytes_of(const std::string& name) const { return read_file(folder() / name); }
};

TEST_F(PreviewsOf, AShotAreItsPicturesASheetAndAGif) {
  const ProgramResult result = run_with("dir: p/, gif: p.gif, contact_sheet: p.png");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.output, "./p/%04d.png\n./p.gif\n./p.png\n");
  EXPECT_EQ(names_in("p").size(), 25u);
  EXPECT_EQ(names_in("p").back(), "0024.png");
  EXPECT_FALSE(exists("bar.glb"));
  const Picture picture = read_picture(folder() / "p/0007.png");
  EXPECT_EQ(picture.width, 64);
  EXPECT_EQ(picture.height, 36);
  EXPECT_EQ(read_tags(folder() / "p/0007.png")->frame, 7);
  EXPECT_THAT(bytes_of("p.gif"), testing::StartsWith("GIF89a"));
  EXPECT_THAT(result.errors, HasSubstr("25 pictures\n"));
  EXPECT_THAT(result.errors, HasSubstr("film: ffmpeg -framerate 24 -i p/%04d.png"));
}

TEST_F(PreviewsOf, AShotLieInAFolderOfItsName) {
  ASSERT_EQ(run_with("frames: [0, 24]").exit_code, 0);
  EXPECT_THAT(names_in("shot"), testing::ElementsAre("0000.png", "0024.png"));
}

TEST_F(PreviewsOf, AnyFramesAndThreadsAreTheSameFiles) {
  for (const char* camera :
       {"", ", camera: {fit: rest}", ", turntable: 0.5, style: displacement, overlay: true",
        ", style: displacement, camera: {fit: rest}", ", style: lambda"}) {
    const auto to = [&](const std::string& dir, const std::vector<std::string>& arguments) {
      const ProgramResult result = run_with(fmt::format("dir: {}{}", dir, camera), arguments);
      EXPECT_EQ(result.exit_code, 0) << result.errors;
    };
    to("whole", {"--threads", "1"});
    to("parts", {"--frames", "0-9"});
    to("parts", {"--frames", "10-24", "--threads", "3"});
    ASSERT_EQ(names_in("parts"), names_in("whole"));
    for (const std::string& name : names_in("whole"))
      EXPECT_EQ(bytes_of("whole/" + name), bytes_of("parts/" + name)) << name << camera;
    fs::remove_all(folder() / "whole");
    fs::remove_all(folder() / "parts");
  }
}

TEST_F(PreviewsOf, TheSameInputsAreNotDrawnAgain) {
  const std::string keys = "dir: p, gif: p.gif, contact_sheet: {path: s.png, at: [0.5s]}";
  ASSERT_EQ(run_with(keys).exit_code, 0);
  const fs::file_time_type before = fs::last_write_time(folder() / "p/0003.png");
  const std::string gif = bytes_of("p.gif"), sheet = bytes_of("s.png");
  fs::remove(folder() / "p/0004.png");
  fs::remove(folder() / "p.gif");
  fs::remove(folder() / "s.png");
  const ProgramResult again = run_with(keys);
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_THAT(again.errors, HasSubstr("25 pictures, 24 of them drawn before"));
  EXPECT_EQ(fs::last_write_time(folder() / "p/0003.png"), before);
  EXPECT_EQ(bytes_of("p.gif"), gif) << "made of the same pictures";
  EXPECT_EQ(bytes_of("s.png"), sheet);
}

TEST_F(PreviewsOf, OtherInputsAreDrawnAgain) {
  ASSERT_EQ(run_with("dir: p").exit_code, 0);
  for (const char* change : {"dir: p, camera: {azimuth: 36deg}", "dir: p, style: normals",
                             "dir: p, style: normals, overlay: true", "dir: p, handles: true"}) {
    const ProgramResult result = run_with(change);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.errors, HasSubstr("25 pictures\n")) << change;
  }
}

TEST_F(PreviewsOf, OnlyFramesThatChangeAreDrawnAgain) {
  const std::string keys = "dir: p, camera: {fit: rest}";
  ASSERT_EQ(run_with(keys).exit_code, 0);
  const ProgramResult other = run_with(keys, {"--set", "lambda={0.5s: 0.5, 1s: 0}"});
  EXPECT_EQ(other.exit_code, 0) << other.errors;
  EXPECT_THAT(other.errors, HasSubstr("25 pictures, 13 of them drawn before")) << "up to the first other λ";
}

TEST_F(PreviewsOf, PickedFramesLeaveTheGifAndTheSheetAlone) {
  const std::string keys = "dir: p, frames: [0-24x2], gif: p.gif, contact_sheet: s.png";
  ASSERT_EQ(run_with(keys, {"--frames", "0-7"}).exit_code, 0);
  EXPECT_THAT(names_in("p"), testing::ElementsAre("0000.png", "0002.png", "0004.png", "0006.png"));
  EXPECT_FALSE(exists("p.gif") || exists("s.png"));
}

TEST_F(PreviewsOf, ASweepShareASheetWithARowATimeAndAColumnALambda) {
  const ProgramResult result =
      run_with("contact_sheet: {path: s.png, at: [0.5s, 1s], width: 64}, frames: [12, 24]",
               {"--set", "sweep={lambda: [0, 0.5, 1]}"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(names_in("shot_0.5"), testing::ElementsAre("0012.png", "0024.png"));
  Sheet expected;
  expected.columns = 3;
  for (const char* frame : {"0012.png", "0024.png"})
    for (const char* lambda : {"shot_0", "shot_0.5", "shot_1"})
      expected.cells.push_back(read_picture(folder() / lambda / frame));
  expected.column_labels = {"λ = 0", "λ = 0.5", "λ = 1"};
  expected.row_labels = {"0.5 s", "1 s"};
  write_picture(draw_sheet(expected), folder() / "expected.png");
  EXPECT_EQ(bytes_of("s.png"), bytes_of("expected.png"));
}

TEST_F(PreviewsOf, RenderWritesPicturesAlone) {
  write("shot.yaml",
        std::string(test::minimal_shot)
            .replace(std::string(test::minimal_shot).find("output:"), std::string::npos,
                     fmt::format("output: {{gltf: bar.glb, cache: bar.pc2, preview: {{{}}}}}\n", small)));
  const ProgramResult result = run({"render", "shot.yaml", "--frames", "0,24", "-d", "out"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(names_in("out/shot"), testing::ElementsAre("0000.png", "0024.png"));
  EXPECT_THAT(names_in("out"), testing::ElementsAre(".flexkey", "shot"));
}

TEST_F(PreviewsOf, RenderTakesWhatIsSolved) {
  const std::string output = fmt::format("output={{preview: {{{}}}}}", small);
  ASSERT_EQ(run({"solve", "shot.yaml"}).exit_code, 0);
  const ProgramResult result = run({"render", "shot.yaml", "--no-solve", "--frames", "3,5", "--set", output});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(names_in("shot"), testing::ElementsAre("0003.png", "0005.png"));
  const std::string from_state = bytes_of("shot/0005.png");
  fs::remove_all(folder() / "shot");
  ASSERT_EQ(run({"render", "shot.yaml", "-d", "anew", "--set", output}).exit_code, 0);
  EXPECT_EQ(bytes_of("anew/shot/0005.png"), from_state);
}

TEST_F(PreviewsOf, RenderWithoutSolvingNeedsAllThatTheCameraHolds) {
  const auto render = [&](const std::string& fit) {
    return run({"render", "shot.yaml", "--no-solve", "--frames", "3", "--set",
                fmt::format("output={{preview: {{camera: {{fit: {}}}, {}}}}}", fit, small)});
  };
  EXPECT_EQ(render("clip").exit_code, 2) << "there is no state";
  ASSERT_EQ(run({"solve", "shot.yaml", "--frames", "0-9"}).exit_code, 0);
  EXPECT_EQ(render("rest").exit_code, 0);
  const ProgramResult part = render("clip");
  EXPECT_EQ(part.exit_code, 2);
  EXPECT_THAT(part.errors, HasSubstr("10 of 25 frames"));
}

TEST_F(PreviewsOf, AreDrawnWhereNoStateCanBeKept) {
  write(".flexkey", "not a folder");
  const ProgramResult result = run_with("dir: p");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  fs::remove(folder() / ".flexkey");
  ASSERT_EQ(run_with("dir: q").exit_code, 0);
  for (const std::string& name : names_in("q"))
    EXPECT_EQ(bytes_of("p/" + name), bytes_of("q/" + name)) << name;
}

TEST_F(PreviewsOf, PickedFramesAreThoseOfTheOtherFilesToo) {
  const std::string output = fmt::format("output={{gltf: bar.glb, cache: bar.mdd, preview: {{{}}}}}", small);
  ASSERT_EQ(run({"animate", "shot.yaml", "--frames", "4-8", "--set", output}).exit_code, 0);
  const std::string glb = bytes_of("bar.glb"), cache = bytes_of("bar.mdd");
  ASSERT_EQ(
      run({"animate", "shot.yaml", "--frames", "4-8", "--set", "output={gltf: bar.glb, cache: bar.mdd}"})
          .exit_code,
      0);
  EXPECT_EQ(bytes_of("bar.glb").size(), glb.size());
  EXPECT_EQ(bytes_of("bar.mdd"), cache);
}

TEST_F(PreviewsOf, RenderDrawsThoseThatTheShotDoesNotName) {
  ASSERT_EQ(run({"solve", "shot.yaml"}).exit_code, 0);
  const ProgramResult result = run({"render", "shot.yaml", "--frames", "0,4", "--no-solve"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(names_in("shot"), testing::ElementsAre("0000.png", "0004.png"));
}

TEST_F(PreviewsOf, AreInTheReport) {
  const ProgramResult result = run_with("dir: p, format: jpg, gif: p.gif", {"--json", "-q"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json output = json::parse(result.output)["runs"][0]["outputs"][0];
  EXPECT_EQ(output["path"], "./p/%04d.jpg");
  EXPECT_EQ(output["format"], "jpg");
  EXPECT_EQ(output["pictures"], 25);
  EXPECT_EQ(output["drawn"], 25);
  EXPECT_EQ(output["files"], json::array({"./p.gif"}));
  EXPECT_THAT(output["ffmpeg"], MatchesRegex("ffmpeg .*p.mp4"));
}

TEST_F(PreviewsOf, AMeshThatCannotBeSubdividedAreDrawnWithOneWarning) {
  write("bar.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv -1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
  const ProgramResult result = run_with("dir: p, frames: [0-3]");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.errors.find("drawn without subdivision"), std::string::npos)
      << "level 0 is not subdivided";
  const ProgramResult fine = run_with("dir: q, frames: [0-3]", {"--set", "output.preview.subdivide=1"});
  ASSERT_EQ(fine.exit_code, 0) << fine.errors;
  const std::string warning = "bar.obj: drawn without subdivision, because the mesh has 1 non-manifold edge";
  EXPECT_THAT(fine.errors, HasSubstr(warning));
  EXPECT_EQ(fine.errors.find(warning), fine.errors.rfind(warning)) << "once";
}

TEST_F(PreviewsOf, NeverReplaceAnInputOrAnother) {
  write("bar.mtl", "newmtl m\nmap_Kd t.png\n");
  write("t.png", "an image");
  write("bar.obj", "mtllib bar.mtl\nusemtl m\n" + test::obj_text(meshes::bar(3, 3, 12)));
  for (const char* command : {"animate", "check"}) {
    const ProgramResult result =
        run({command, "shot.yaml", "--set", "output={preview: {contact_sheet: t.png}}"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, HasSubstr("the output './t.png' would replace an input"));
  }
  const ProgramResult twice = run_with("dir: p, contact_sheet: p/0003.png");
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_THAT(twice.errors, HasSubstr("the output './p/0003.png' is named twice"));
  EXPECT_EQ(bytes_of("t.png"), "an image");
}

TEST_F(PreviewsOf, WhatCannotBeWrittenExitFiveBeforeSolving) {
  write("file", "not a folder");
  const ProgramResult result = run_with("dir: file/p");
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_THAT(result.errors, HasSubstr("cannot write './file/p/0000.png': Not a directory"));
  EXPECT_THAT(result.errors, Not(HasSubstr("Progress")));
}

TEST_F(PreviewsOf, OnAFullDiskExitFive) {
  for (const char* camera : {"{fit: clip}", "{fit: rest}"}) {
    fs::create_directory(folder() / "p");
    fs::create_symlink("/dev/full", folder() / "p/0005.png");
    const ProgramResult result = run_with(fmt::format("dir: p, camera: {}", camera));
    EXPECT_EQ(result.exit_code, 5);
    EXPECT_THAT(result.errors, HasSubstr("cannot write './p/0005.png': No space left"));
    EXPECT_TRUE(exists("p/0004.png"));
    for (const std::string& name : names_in("p")) EXPECT_THAT(name, Not(HasSubstr("part")));
    fs::remove_all(folder() / "p");
  }
}

TEST_F(PreviewsOf, OverAFileSizeLimitExitFiveAndLeaveNoHalfFile) {
  const ProgramResult result = run_with("dir: p", {}, "ulimit -f 4;");
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_THAT(result.errors, HasSubstr("File too large"));
  EXPECT_TRUE(names_in("p").empty());
}

TEST_F(PreviewsOf, TheSampleShotAreAFilmASheetAndPictures) {
  const ProgramResult result = run({"animate", FLEXKEY_SOURCE "/timelines/nose.yaml", "-d", "out", "--set",
                                    "output.preview.frames=[0-144x36]"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(exists("out/nose/0000.png") && exists("out/nose/0144.png"));
  EXPECT_TRUE(exists("out/nose.png") && exists("out/nose.gif"));
}

/// Runs a program and interrupts it once it has written its second picture.
constexpr const char* interrupting =
    "sh -c '\"$@\" & while kill -0 $! && [ ! -e out/0001.png ]; do sleep 0.02; done; kill -INT $!; wait $!' "
    "sh";

TEST_F(PreviewsOf, AnInterruptKeepsWholePictures) {
  for (const char* camera : {"{fit: clip}", "{fit: rest}"}) {
    const ProgramResult result = run_with(fmt::format("dir: out, camera: {}, gif: p.gif", camera),
                                          {"--set", "output.preview.size=[400, 300]", "--set",
                                           "output.preview.quality=final", "--set", "fps=100"},
                                          interrupting);
    EXPECT_EQ(result.exit_code, 130) << result.errors;
    const std::size_t pictures = names_in("out").size();
    EXPECT_THAT(result.errors, HasSubstr(fmt::format("'./out/%04d.png' has {} of 101 pictures", pictures)));
    EXPECT_GT(pictures, 1u);
    EXPECT_LT(pictures, 101u);
    for (const std::string& name : names_in("out"))
      EXPECT_NO_THROW(read_picture(folder() / "out" / name)) << name;
    EXPECT_FALSE(exists("p.gif"));
    fs::remove_all(folder() / "out");
  }
}

TEST_F(PreviewsOf, AnythingWithoutThemDoNotLoadOpenImageIO) {
  const ProgramResult result = run({"animate", "shot.yaml"}, {}, "LD_DEBUG=files");
  ASSERT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.errors, HasSubstr("libstdc++"));
  EXPECT_THAT(result.errors, Not(HasSubstr("libOpenImageIO")));
}

}  // namespace
}  // namespace flexkey
