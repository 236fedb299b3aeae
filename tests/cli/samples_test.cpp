// The sample shots as a visitor runs them, and the README that shows them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "cli/work_folder.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey {
namespace {

namespace fs = std::filesystem;
using test::ProgramResult;
using testing::HasSubstr;
using testing::Not;

const fs::path source = FLEXKEY_SOURCE;

bool names_pictures(const fs::path& timeline) {
  return read_file(timeline).find("preview:") != std::string::npos;
}

class Samples : public test::WorkFolder {};

TEST_F(Samples, EveryShotGivesAGlbThatTheValidatorAccepts) {
  std::string files;
  for (const char* name : {"nose", "leg", "jaw", "twist", "minimal"}) {
    std::vector<std::string> arguments{
        "animate", (source / "timelines" / (std::string(name) + ".yaml")).string(), "-d", "out"};
    if (name == std::string("nose"))  // without its pictures
      arguments.insert(arguments.end(), {"--set", "output={gltf: nose.glb, html: nose.html}"});
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    const std::string glb = result.output.substr(0, result.output.find('\n'));
    EXPECT_EQ(fs::path(glb).filename(), std::string(name == std::string("minimal") ? "bar" : name) + ".glb");
    files += fmt::format(" '{}'", (folder() / glb).string());
  }
  EXPECT_TRUE(fs::exists(folder() / "out/nose.html"));
  const fs::path validate = source / "tools/validate";
  if (!fs::exists(validate / "node_modules"))
    GTEST_SKIP() << "glTF-Validator is not installed: npm ci in " << validate;
  EXPECT_EQ(std::system(fmt::format("node '{}/validate.mjs'{}", validate.string(), files).c_str()), 0);
}

TEST_F(Samples, TheReferenceWritesAllThatItNames) {
  if (FLEXKEY_HAS_PREVIEWS == 0) GTEST_SKIP() << "it names pictures";
  const ProgramResult result = run({"animate", (source / "timelines/reference.yaml").string(), "-d", "out"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  for (const char* name : {"reference.json", "reference.png", "reference_0.glb", "reference_1.gif",
                           "reference_1.html", "reference_1.mdd", "reference_1.usda", "reference_1/0024.png"})
    EXPECT_TRUE(fs::exists(folder() / "out" / name)) << name;
}

TEST_F(Samples, TheLongBarConvergesInEveryFrame) {
  const ProgramResult result = run({"animate", (source / "timelines/twist.yaml").string(), "--strict"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.errors, Not(HasSubstr("slipped")));
}

TEST_F(Samples, EveryShotPassesCheckWithoutAWarning) {
  for (const fs::directory_entry& entry : fs::directory_iterator(source / "timelines")) {
    if (entry.path().extension() != ".yaml") continue;
    if (FLEXKEY_HAS_PREVIEWS == 0 && names_pictures(entry.path())) continue;
    const ProgramResult result = run({"check", entry.path().string()});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
  }
}

TEST(Readme, ShowsTheSmallestTimelineAndTheExampleAsTheyAre) {
  const std::string readme = read_file(source / "README.md");
  const std::string timeline = read_file(source / "timelines/minimal.yaml");
  const std::string example = read_file(source / "tests/install/example.cpp");
  EXPECT_THAT(readme, HasSubstr(timeline.substr(timeline.find('\n') + 1)));  // below its comment
  EXPECT_THAT(readme, HasSubstr(example.substr(example.find('\n') + 1)));
}

}  // namespace
}  // namespace flexkey
