#include "flexkey/preview/images/module.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/read_file.h"
#include "flexkey/preview/images/draw.h"
#include "flexkey/preview/images/image_file.h"
#include "preview_images/test_folder.h"

namespace flexkey {
namespace {

using testing::ExitedWithCode;
using testing::HasSubstr;
using testing::Not;

/// What each test needs: a process of its own in which nothing is loaded yet.
class Module : public test::TestFolder {
 protected:
  void SetUp() override {
    TestFolder::SetUp();
    GTEST_FLAG_SET(death_test_style, "threadsafe");
  }
};

bool openimageio_is_loaded() {
  std::ifstream maps("/proc/self/maps");
  return std::string(std::istreambuf_iterator<char>(maps), {}).find("libOpenImageIO") != std::string::npos;
}

[[noreturn]] void load_from(const std::filesystem::path& folder) {
  setenv("FLEXKEY_MODULES", folder.c_str(), 1);
  std::fputs(test::message_of([] { image_module(); }).c_str(), stderr);
  std::exit(7);
}

TEST_F(Module, IsLoadedWithTheFirstPictureAndNotBefore) {
  EXPECT_EXIT(
      {
        Picture picture = blank_picture(8, 8, {});
        fill(picture, {2, 2, 4, 4}, {{1, 1, 1}});
        const bool early = openimageio_is_loaded();
        write_picture(picture, folder() / "x.png");
        std::exit(!early && openimageio_is_loaded() ? 7 : 1);
      },
      ExitedWithCode(7), "");
}

TEST_F(Module, WhereItIsMissingThePackageIsNamed) {
  EXPECT_EXIT(load_from(folder()), ExitedWithCode(7),
              "cannot make pictures: no flexkey_images.so in .*; to have it, install the package "
              "libopenimageio-dev and build flexkey again");
}

TEST_F(Module, WhereOpenImageIOIsMissingThePackageIsNamed) {
  std::ofstream(folder() / "flexkey_images.so") << "cannot be loaded";
  EXPECT_EXIT(load_from(folder()), ExitedWithCode(7),
              "cannot make pictures: .*; install the package libopenimageio2.4");
}

TEST_F(Module, IsLookedForBesideTheProgramByDefault) {
  EXPECT_EXIT(
      {
        unsetenv("FLEXKEY_MODULES");
        std::fputs(test::message_of([] { image_module(); }).c_str(), stderr);
        std::exit(7);
      },
      ExitedWithCode(7), "no flexkey_images.so in '.*/preview_images' or '.*/lib.*/flexkey'");
}

TEST_F(Module, IsNotLoadedByACommandThatMakesNoPicture) {
  const std::string command =
      fmt::format("LD_DEBUG=files '{}' check '{}/timelines/minimal.yaml' >/dev/null 2>'{}'", FLEXKEY_PROGRAM,
                  FLEXKEY_SOURCE, (folder() / "loaded").string());
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string loaded = read_file(folder() / "loaded");
  EXPECT_THAT(loaded, HasSubstr("libstdc++"));
  EXPECT_THAT(loaded, Not(HasSubstr("libOpenImageIO")));
  EXPECT_THAT(loaded, Not(HasSubstr("flexkey_images")));
}

}  // namespace
}  // namespace flexkey
