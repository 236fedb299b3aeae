#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/work_folder.h"

namespace flexkey::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Inspect : public WorkFolder {};

TEST_F(Inspect, CountsWhatTheMeshHas) {
  const ProgramResult result = run({"inspect", "bar.obj", "--json"});
  EXPECT_EQ(result.exit_code, 0);
  const json report = json::parse(result.output);
  const Mesh bar = meshes::bar(3, 3, 12);
  EXPECT_EQ(report["vertices"], bar.vertex_count());
  EXPECT_EQ(report["faces"], bar.face_count());
  EXPECT_EQ(report["triangles"].get<int>() + report["quads"].get<int>() + report["polygons"].get<int>(),
            bar.face_count());
  EXPECT_EQ(report["vertices"].get<int>() - report["edges"].get<int>() + report["faces"].get<int>(), 2)
      << "Euler";
  EXPECT_EQ(report["components"], json({bar.vertex_count()}));
  EXPECT_TRUE(report["boundary_loops"].empty());
  EXPECT_TRUE(report["defects"].empty());
  EXPECT_EQ(report["bounds"]["max"], json({3.0, 3.0, 12.0}));
}

TEST_F(Inspect, NamesGroupsBordersAndDefectsForAPerson) {
  write("open.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 9 9 9\ng lid\nf 1 2 3 4\nf 1 1 2\n");
  const ProgramResult result = run({"inspect", "open.obj"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, HasSubstr("groups      lid"));
  EXPECT_THAT(result.output, HasSubstr("boundaries  4 vertices, 6 long"));
  EXPECT_THAT(result.output, HasSubstr("defects     1 degenerate face"));
}

TEST_F(Inspect, SaysWhatItCannotRead) {
  const ProgramResult missing = run({"inspect", "nothing.obj"});
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_THAT(missing.errors, HasSubstr("nothing.obj"));
  write("bad.obj", "v 0 0\n");
  EXPECT_EQ(run({"inspect", "bad.obj"}).exit_code, 3);
  EXPECT_EQ(run({"inspect"}).exit_code, 2);
}

}  // namespace
}  // namespace flexkey::test
