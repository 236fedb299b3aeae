#include "flexkey/cache/obj_sequence.h"

#include <gmock/gmock.h>

#include <fstream>

#include "cache/frames.h"
#include "flexkey/mesh/obj.h"

namespace flexkey {
namespace {

using test::add_frame;
using test::write_all;
using testing::HasSubstr;

class ObjSequence : public test::Folder {
 protected:
  FramePath numbered() const {
    return [this](int k) { return *this / ("frames/" + std::to_string(k) + ".obj"); };
  }
  Mesh frame(int k) const { return read_obj(numbered()(k)).mesh; }
};

TEST_F(ObjSequence, KeepsTheMeshAndTakesTheFramesPositions) {
  const Mesh mesh = test::mixed_mesh();
  const CacheShape shape{"shot", mesh, 24, {0, 5}, {}};
  const std::uintmax_t bytes = write_all(obj_sequence_sink(numbered(), shape), shape);
  EXPECT_EQ(bytes, std::filesystem::file_size(numbered()(0)) + std::filesystem::file_size(numbered()(5)));
  for (const int k : shape.frames) {
    const Mesh read = frame(k);
    EXPECT_EQ(read.positions, test::posed(mesh, k)) << "to the last bit";
    EXPECT_EQ(read.face_offsets, mesh.face_offsets);
    EXPECT_EQ(read.corners, mesh.corners);
    EXPECT_EQ(read.texcoords, mesh.texcoords);
    EXPECT_EQ(read.corner_texcoord, mesh.corner_texcoord);
    ASSERT_EQ(read.groups.size(), mesh.groups.size());
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
      EXPECT_EQ(read.groups[g].name, mesh.groups[g].name);
      EXPECT_EQ(read.groups[g].faces, mesh.groups[g].faces);
    }
    ASSERT_EQ(read.materials.size(), mesh.materials.size());
    EXPECT_EQ(read.materials[0].name, "shiny red");
    EXPECT_EQ(read.face_material, mesh.face_material);
  }
}

TEST_F(ObjSequence, KeepsWhatIsSharp) {
  Mesh mesh = meshes::cube();
  mesh.creases = {{mesh.face(0)[0], mesh.face(0)[1], 2.5}};
  mesh.sharp_vertices = {{7, 10}};
  const CacheShape shape{"shot", mesh, 24, {0}, {}};
  write_all(obj_sequence_sink(numbered(), shape), shape);
  const Mesh read = frame(0);
  ASSERT_EQ(read.creases.size(), 1u);
  EXPECT_EQ(read.creases[0].to, mesh.creases[0].to);
  EXPECT_EQ(read.creases[0].sharpness, 2.5);
  ASSERT_EQ(read.sharp_vertices.size(), 1u);
  EXPECT_EQ(read.sharp_vertices[0].vertex, 7);
}

TEST_F(ObjSequence, FirstLineSaysFrameAndLambda) {
  const Mesh mesh = meshes::cube();
  const CacheShape shape{"shot", mesh, 24, {25}, {}};
  write_all(obj_sequence_sink(numbered(), shape), shape);
  EXPECT_THAT(read_file(numbered()(25)), testing::StartsWith("# frame 25, lambda 0.25\n"));
}

TEST_F(ObjSequence, FindsTheMaterialsFromWhereItLies) {
  Mesh mesh = test::mixed_mesh();
  std::ofstream(*this / "paint.mtl") << "newmtl blue\nKd 0 0 1\n";
  const CacheShape shape{"shot", mesh, 24, {0}, {}};
  write_all(obj_sequence_sink(numbered(), shape, {*this / "paint.mtl"}), shape);
  EXPECT_THAT(read_file(numbered()(0)), HasSubstr("mtllib ../paint.mtl\n"));
  const Mesh read = frame(0);
  EXPECT_EQ(read.materials.front().base_color, Vec3(0, 0, 1));
}

TEST_F(ObjSequence, NamesCannotBreakALine) {
  Mesh mesh = test::mixed_mesh();
  mesh.groups[0].name = "left arm\nv 1 2 3";
  mesh.materials[0].name = "red\nv 1 2 3";
  mesh.materials[1].name = "#1";
  const CacheShape shape{"shot", mesh, 24, {0}, {}};
  write_all(obj_sequence_sink(numbered(), shape), shape);
  const Mesh read = frame(0);
  EXPECT_EQ(read.vertex_count(), 12);
  EXPECT_EQ(read.groups[0].name, "left_arm_v_1_2_3");
  EXPECT_EQ(read.face_material, mesh.face_material);
}

TEST_F(ObjSequence, AFrameIsWholeBeforeTheNextComes) {
  const Mesh mesh = meshes::cube();
  const CacheShape shape{"shot", mesh, 24, {0, 1}, {}};
  const FrameSink sink = obj_sequence_sink(numbered(), shape);
  add_frame(sink, shape, 0);
  EXPECT_EQ(frame(0).positions, test::posed(mesh, 0));
  EXPECT_FALSE(std::filesystem::exists(numbered()(1)));
}

}  // namespace
}  // namespace flexkey
