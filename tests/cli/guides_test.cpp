// timelines/GUIDES.md, run from top to bottom as a reader would.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>

#include "cli/work_folder.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey::test {
namespace {

const std::filesystem::path source = FLEXKEY_SOURCE;

/// A fenced piece of the page.
struct Block {
  std::string language;
  std::string text;
};

std::string guides() {
  return read_file(source / "timelines/GUIDES.md");
}

std::vector<Block> blocks_of(const std::string& page) {
  std::vector<Block> blocks;
  std::istringstream lines(page);
  bool is_inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      is_inside = !is_inside;
      if (is_inside) blocks.push_back({line.substr(3), ""});
    } else if (is_inside) {
      blocks.back().text += line + "\n";
    }
  }
  return blocks;
}

class Guides : public WorkFolder {
 protected:
  void SetUp() override {
    WorkFolder::SetUp();
    std::filesystem::create_directory_symlink(source / "timelines", folder() / "timelines");
  }
  /// A line of a shell in the folder, with the program in its path.
  void run_line(const std::string& line) const {
    SCOPED_TRACE(line);
    ASSERT_TRUE(line.starts_with("flexkey "));
    if (!FLEXKEY_HAS_PREVIEWS && line.find("--picture") != std::string::npos) return;
    const std::string command =
        fmt::format("cd '{}' && PATH='{}':\"$PATH\" && {} >said 2>&1", folder().string(),
                    std::filesystem::path(FLEXKEY_PROGRAM).parent_path().string(), line);
    EXPECT_EQ(std::system(command.c_str()), 0) << read_file(folder() / "said");
    EXPECT_THAT(read_file(folder() / "said"), testing::Not(testing::HasSubstr("warning:")));
  }
};

TEST_F(Guides, EveryCommandAndTimelineRuns) {
  int timelines = 0, commands = 0;
  for (const Block& block : blocks_of(guides())) {
    if (block.language == "yaml") {
      ASSERT_TRUE(block.text.starts_with("# ")) << "a timeline begins with its name:\n" << block.text;
      write(block.text.substr(2, block.text.find('\n') - 2), block.text);
      ++timelines;
    } else if (block.language == "sh") {
      std::istringstream lines(block.text);
      for (std::string line; std::getline(lines, line); ++commands) run_line(line);
    } else {
      EXPECT_THAT(block.language, testing::AnyOf("html", "gdscript"));
    }
  }
  EXPECT_GE(timelines, 4);
  EXPECT_GE(commands, 10);
  for (const char* made : {"pig.glb", "pig.html", "bar.mdd", "bar.pc2", "rig.glb", "shot.glb", "leg_0.8.glb"})
    EXPECT_TRUE(std::filesystem::exists(folder() / "out" / made)) << made;
}

TEST_F(Guides, PicturesAreThereAndThreeIsTheVersionThatTheTestsPlay) {
  const std::string page = guides();
  const std::regex picture(R"(\]\((\.\./[^)]+)\))");
  for (std::sregex_iterator found(page.begin(), page.end(), picture), end; found != end; ++found)
    EXPECT_TRUE(std::filesystem::exists(source / "timelines" / (*found)[1].str())) << (*found)[1];
  std::smatch version;
  const std::string package = read_file(source / "tools/viewer/package.json");
  ASSERT_TRUE(std::regex_search(package, version, std::regex(R"-("three": "([0-9.]+)")-")));
  EXPECT_THAT(page, testing::HasSubstr(fmt::format("three@{}/build", version[1].str())));
}

}  // namespace
}  // namespace flexkey::test
