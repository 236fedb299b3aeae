#include "flexkey/preview/images/module.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "flexkey/mesh/read_file.h"
#include "preview_images/test_folder.h"

namespace flexkey {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr const char* module_name = "flexkey_images.so";
constexpr const char* loaded_late = "before: no\nafter: yes\n";

/// Runs copies of a small program in a folder like the one that flexkey is installed in.
class Module : public test::TestFolder {
 protected:
  void SetUp() override {
    TestFolder::SetUp();
    fs::create_directories(program().parent_path());
    fs::create_directories(installed().parent_path());
    fs::copy_file(FLEXKEY_PROBE, program());
  }
  fs::path program() const { return folder() / "bin" / "probe"; }
  fs::path beside() const { return folder() / "bin" / module_name; }
  fs::path installed() const { return folder() / FLEXKEY_LIBRARIES / "flexkey" / module_name; }
  static void copy_module(const fs::path& to) {
    fs::copy_file(fs::path(FLEXKEY_MODULE_FOLDER) / module_name, to);
  }
  /// What the program says.
  std::string run(const std::string& environment = "-u FLEXKEY_MODULES") const {
    const std::string command =
        fmt::format("cd '{}' && env {} bin/probe x.png >said 2>&1; true", folder().string(), environment);
    EXPECT_EQ(std::system(command.c_str()), 0);
    return read_file(folder() / "said");
  }
};

TEST_F(Module, IsLoadedFromBesideTheProgramWithTheFirstPicture) {
  copy_module(beside());
  EXPECT_EQ(run(), loaded_late);
  EXPECT_TRUE(fs::exists(folder() / "x.png"));
}

TEST_F(Module, IsLoadedFromThePrefixOfAnInstalledProgram) {
  copy_module(installed());
  EXPECT_EQ(run(), loaded_late);
}

TEST_F(Module, IsLoadedFromTheFolderThatTheEnvironmentNames) {
  EXPECT_EQ(run("FLEXKEY_MODULES='" FLEXKEY_MODULE_FOLDER "'"), loaded_late);
}

TEST_F(Module, WhereItIsMissingThePackageIsNamedAndNothingIsWritten) {
  const fs::path real = fs::canonical(folder());
  EXPECT_EQ(
      run(),
      fmt::format("before: no\nerror: cannot make pictures: no {} in '{}' or '{}'; to have it, install "
                  "the package libopenimageio-dev and build flexkey again\n",
                  module_name, (real / "bin").string(), (real / FLEXKEY_LIBRARIES / "flexkey").string()));
  EXPECT_THAT(names(), testing::ElementsAre("bin", testing::_, "said"));
}

TEST_F(Module, WhereOpenImageIOIsMissingThePackageIsNamed) {
  std::ofstream(beside()) << "cannot be loaded, as if a library of it were missing";
  EXPECT_THAT(run(), testing::MatchesRegex("before: no\nerror: cannot make pictures: .*flexkey_images.so.*; "
                                           "install the package libopenimageio2.4\n"));
}

TEST_F(Module, IsNotLoadedByACommandThatMakesNoPicture) {
  const std::string command =
      fmt::format("LD_DEBUG=files '{}' check '{}/timelines/minimal.yaml' >/dev/null 2>'{}'", FLEXKEY_PROGRAM,
                  FLEXKEY_SOURCE, (folder() / "loaded").string());
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string loaded = read_file(folder() / "loaded");
  EXPECT_THAT(loaded, HasSubstr("libstdc++"));
  EXPECT_THAT(loaded, Not(HasSubstr("libOpenImageIO")));
  EXPECT_THAT(loaded, Not(HasSubstr(module_name)));
}

}  // namespace
}  // namespace flexkey
