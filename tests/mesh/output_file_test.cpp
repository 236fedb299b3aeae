#include "flexkey/mesh/output_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey {
namespace {

namespace fs = std::filesystem;

class OutputFileTest : public testing::Test {
 protected:
  void SetUp() override { fs::remove_all(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::size_t files() const {
    return fs::exists(folder_) ? static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}))
                               : 0;
  }
  const fs::path folder_ =
      fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST_F(OutputFileTest, AppearsUnderItsNameWhenCommitted) {
  const fs::path path = folder_ / "deep" / "er" / "x.bin";
  OutputFile file(path);
  file.write("whole");
  EXPECT_FALSE(fs::exists(path));
  file.commit();
  EXPECT_EQ(read_file(path), "whole");
  EXPECT_EQ(file.bytes_written(), 5u);
}

TEST_F(OutputFileTest, LeavesNothingWhereItIsNotCommitted) {
  { OutputFile(folder_ / "x.bin").write("half"); }
  EXPECT_EQ(files(), 0u);
}

TEST_F(OutputFileTest, OfAKilledProgramNothingIsLeft) {
  fs::create_directories(folder_);
  const int probe = open(folder_.c_str(), O_WRONLY | O_TMPFILE, 0666);
  if (probe < 0) GTEST_SKIP() << "this file system has no files without names";
  close(probe);
  const pid_t program = fork();
  if (program == 0) {
    OutputFile file(folder_ / "x.bin");
    file.write("half");
    raise(SIGKILL);
  }
  ASSERT_EQ(waitpid(program, nullptr, 0), program);
  EXPECT_EQ(files(), 0u);
}

TEST_F(OutputFileTest, KeepsTheOldFileUntilTheNewOneIsWhole) {
  const fs::path path = folder_ / "x.bin";
  OutputFile first(path);
  first.write("old");
  first.commit();
  { OutputFile(path).write("half"); }
  EXPECT_EQ(read_file(path), "old");
  OutputFile second(path);
  second.write("new");
  second.commit();
  EXPECT_EQ(read_file(path), "new");
  EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFileTest, AFullDiskIsAnError) {
  const std::string message = message_of([] {
    OutputFile file("/dev/full");
    file.write(std::string(100000, 'x'));
    file.commit();
  });
  EXPECT_EQ(message, "cannot write '/dev/full': No space left on device");
}

TEST_F(OutputFileTest, AFolderOrAFileInThePlaceOfAFolderIsAnError) {
  OutputFile file(folder_ / "x.bin");
  file.commit();
  EXPECT_THAT(message_of([&] { OutputFile(folder_ / "x.bin" / "y.bin"); }),
              testing::HasSubstr("Not a directory"));
  EXPECT_THAT(message_of([&] { OutputFile{folder_}; }), testing::HasSubstr("Is a directory"));
}

TEST(ReadFile, NamesTheFileAndTheReason) {
  EXPECT_EQ(message_of([] { read_file("no/such.obj"); }),
            "cannot read 'no/such.obj': No such file or directory");
  EXPECT_EQ(message_of([] { read_file("/"); }), "cannot read '/': Is a directory");
}

}  // namespace
}  // namespace flexkey
