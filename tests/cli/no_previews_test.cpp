// A program that is built without the libraries that draw pictures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/work_folder.h"

namespace flexkey {
namespace {

using test::ProgramResult;
using testing::HasSubstr;

class NoPreviews : public test::WorkFolder {
 protected:
  void SetUp() override {
    WorkFolder::SetUp();
    write("shot.yaml", test::minimal_shot);
  }
};

TEST_F(NoPreviews, AreRefusedWithTheirPlace) {
  for (const char* command : {"animate", "check", "render"}) {
    const ProgramResult result = run({command, "shot.yaml", "--set", "output={gltf: bar.glb, preview: p/}"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, HasSubstr("--set output: error: this flexkey is built without previews"));
    EXPECT_FALSE(std::filesystem::exists(folder() / "bar.glb"));
  }
}

TEST_F(NoPreviews, AreNotMissedByOtherOutputs) {
  EXPECT_EQ(run({"animate", "shot.yaml"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder() / "bar.glb"));
}

}  // namespace
}  // namespace flexkey
