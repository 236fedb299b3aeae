#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/work_folder.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class PickCommand : public WorkFolder {};

TEST_F(PickCommand, WritesOnePageThatFetchesNothing) {
  const ProgramResult result = run({"pick", "bar.obj", "-o", "out/pick.html"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.output, "out/pick.html\n");
  const std::string page = read_file(folder() / "out/pick.html");
  EXPECT_THAT(page, HasSubstr("\"name\":\"bar.obj\""));
  EXPECT_THAT(page, Not(HasSubstr("@mesh@")));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

TEST_F(PickCommand, NamesThePageByTheMeshAndReplacesNoMesh) {
  EXPECT_EQ(run({"pick", "bar.obj"}).output, "bar.html\n");
  const std::string mesh = read_file(folder() / "bar.obj");
  EXPECT_EQ(run({"pick", "bar.obj", "-o", "bar.obj"}).exit_code, 2);
  EXPECT_EQ(read_file(folder() / "bar.obj"), mesh);
}

TEST_F(PickCommand, RefusesWhatIsNoMesh) {
  EXPECT_EQ(run({"pick", "missing.obj"}).exit_code, 3);
  EXPECT_EQ(run({"pick"}).exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder() / "missing.html"));
}

}  // namespace
}  // namespace flexkey::test
