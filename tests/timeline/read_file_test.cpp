#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "timeline/parsing.h"

namespace flexkey {
namespace {

std::string failure_of(const std::string& file) {
  try {
    read_timeline(file);
  } catch (const TimelineError& error) {
    return error.what();
  }
  return {};
}

class ReadTimeline : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& bytes) const {
    const std::filesystem::path path = folder_ / name;
    std::ofstream(path, std::ios::binary) << bytes;
    return path.string();
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string("flexkey_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(ReadTimeline, GivesTheBytes) {
  const std::string text = with_base("fps: 30\r\n");
  EXPECT_EQ(read_timeline(write("shot.yaml", text)), text);
}

TEST_F(ReadTimeline, NamesTheFileAndTheReason) {
  const std::string missing = (folder_ / "none.yaml").string();
  EXPECT_EQ(failure_of(missing), missing + ": error: cannot be read: No such file or directory");
  EXPECT_EQ(failure_of(folder_.string()), folder_.string() + ": error: cannot be read: it is a folder");
}

TEST_F(ReadTimeline, RefusesHugeFiles) {
  const std::string most(4 << 20, ' ');
  EXPECT_EQ(read_timeline(write("most.yaml", most)).size(), most.size());
  const std::string over = write("over.yaml", most + " ");
  EXPECT_EQ(failure_of(over), over + ": error: cannot be read: it is larger than 4 MiB");
}

TEST(FormatDiagnostic, NamesThePlace) {
  const Diagnostic error{Diagnostic::Severity::error, {13, 19}, "unknown key 'rotat'"};
  EXPECT_EQ(format_diagnostic("shot.yaml", error), "shot.yaml:13:19: error: unknown key 'rotat'");
  EXPECT_EQ(format_diagnostic("-", error), "<stdin>:13:19: error: unknown key 'rotat'");
  const Diagnostic warning{Diagnostic::Severity::warning, {}, "slow"};
  EXPECT_EQ(format_diagnostic("a/b.yaml", warning), "a/b.yaml: warning: slow");
}

TEST(ShotName, IsThatOfTheFile) {
  EXPECT_EQ(parse_shot(with_base(""), "a/b/nose.v2.yaml").shot.name, "nose.v2");
  EXPECT_EQ(parse_shot(with_base(""), "-").shot.name, "stdin");
}

}  // namespace
}  // namespace flexkey
