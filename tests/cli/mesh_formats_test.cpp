// Meshes of every format go through the whole program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/work_folder.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey {
namespace {

using nlohmann::json;
using test::ProgramResult;
using testing::HasSubstr;

/// The vertices a line, and the faces a line behind their corner counts.
std::string rows_of(const Mesh& mesh) {
  std::string text;
  for (const auto& p : mesh.positions.rowwise()) text += fmt::format("{} {} {}\n", p[0], p[1], p[2]);
  for (int f = 0; f < mesh.face_count(); ++f) {
    text += fmt::format("{}", mesh.face(f).size());
    for (const int v : mesh.face(f)) text += fmt::format(" {}", v);
    text += "\n";
  }
  return text;
}

std::string off_text(const Mesh& mesh) {
  return fmt::format("OFF\n{} {} 0\n{}", mesh.vertex_count(), mesh.face_count(), rows_of(mesh));
}

std::string ply_text(const Mesh& mesh) {
  return fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n{}",
      mesh.vertex_count(), mesh.face_count(), rows_of(mesh));
}

std::string stl_text(const Mesh& mesh) {
  std::string text = "solid bar\n";
  for (int f = 0; f < mesh.face_count(); ++f) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int v : mesh.face(f))
      text +=
          fmt::format("vertex {} {} {}\n", mesh.positions(v, 0), mesh.positions(v, 1), mesh.positions(v, 2));
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid bar\n";
}

class MeshFormats : public test::WorkFolder {
 protected:
  void SetUp() override {
    WorkFolder::SetUp();
    const Mesh bar = meshes::bar(3, 3, 12);
    write("bar.off", off_text(bar));
    write("bar.ply", ply_text(bar));
    write("bar.stl", stl_text(meshes::triangulated(bar)));
    write("shot.yaml", test::minimal_shot);
  }
};

TEST_F(MeshFormats, TheSameMeshGivesTheSameFile) {
  ASSERT_EQ(run({"animate", "shot.yaml", "-d", "obj"}).exit_code, 0);
  for (const std::string format : {"off", "ply"}) {
    const ProgramResult result =
        run({"animate", "shot.yaml", "-d", format, "--json", "--set", "mesh=bar." + format});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    const json report = json::parse(result.output);
    EXPECT_EQ(report["mesh"]["vertices"], meshes::bar(3, 3, 12).vertex_count());
    EXPECT_EQ(report["mesh"]["faces"], meshes::bar(3, 3, 12).face_count()) << "quads stay quads";
    EXPECT_LT(report["runs"][0]["outputs"][0]["error"], 1e-3);
  }
}

TEST_F(MeshFormats, AnStlIsWelded) {
  const ProgramResult result = run({"check", "shot.yaml", "--json", "--set", "mesh=bar.stl"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json report = json::parse(result.output);
  EXPECT_EQ(report["mesh"]["vertices"], meshes::bar(3, 3, 12).vertex_count());
  EXPECT_EQ(report["mesh"]["groups"][0]["name"], "bar");
  EXPECT_EQ(run({"animate", "shot.yaml", "--set", "mesh=bar.stl"}).exit_code, 0);
}

TEST_F(MeshFormats, AreInspected) {
  for (const std::string format : {"off", "ply", "stl"}) {
    const ProgramResult result = run({"inspect", "bar." + format, "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_TRUE(json::parse(result.output)["defects"].empty()) << format;
  }
}

TEST_F(MeshFormats, ABrokenOneIsBadInput) {
  write("bar.ply", read_file(folder() / "bar.ply").substr(0, 400));
  const ProgramResult result = run({"check", "shot.yaml", "--set", "mesh=bar.ply"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.errors, HasSubstr("bar.ply:10: the file is too short for"));
}

TEST_F(MeshFormats, InspectCountsCreases) {
  write("sharp.obj", read_file(folder() / "bar.obj") + "t crease 2/1/0 0 1 3\nt corner 1/1/0 0 2\n");
  const ProgramResult result = run({"inspect", "sharp.obj"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("sharp       1 edges, 1 vertices"));
}

}  // namespace
}  // namespace flexkey
