// What limits.h says: each limit has its message, and nothing near the limit is taken of memory before it.
#include "flexkey/mesh/limits.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/obj.h"
#include "flexkey/mesh/off.h"
#include "flexkey/mesh/ply.h"
#include "flexkey/mesh/read_file.h"
#include "flexkey/mesh/stl.h"

namespace flexkey {
namespace {

std::string refusal(const std::function<void()>& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string of_obj(const std::string& text, const limits::MeshSize& most) {
  return refusal([&] { parse_obj(text, "x.obj", "", most); });
}

TEST(Limits, OfAnObj) {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  EXPECT_EQ(of_obj(square + "f 1 2 3 4\n", {4, 1, 4, 0}), "no error");
  EXPECT_EQ(of_obj(square, {.vertices = 3}), "x.obj:4: more than 3 vertices");
  EXPECT_EQ(of_obj(square + "f 1 2 3\nf 1 3 4\n", {.faces = 1}), "x.obj:6: more than 1 faces");
  EXPECT_EQ(of_obj(square + "f 1 2 3\nf 1 3 4\n", {.corners = 5}), "x.obj:6: more than 5 corners");
  EXPECT_EQ(of_obj("vt 0\nvt 1\n", {.corners = 1}), "x.obj:2: more than 1 texture coordinates");
  EXPECT_EQ(of_obj(square + "g a b c\nf 1 2 3\n", {.group_faces = 2}),
            "x.obj:6: more than 2 faces in groups");
}

TEST(Limits, OfAnOffByItsCounts) {
  const auto refused = [](const std::string& text) { return refusal([&] { parse_off(text, "x.off"); }); };
  EXPECT_EQ(refused("OFF\n20000001 1 0\n"), "x.off:2: more than 20000000 vertices");
  EXPECT_EQ(refused("OFF\n3 40000001 0\n"), "x.off:2: more than 40000000 faces");
  EXPECT_EQ(refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n120000001 0 1 2\n"),
            "x.off:6: more than 120000000 corners");
}

TEST(Limits, OfAPlyByItsCounts) {
  const auto refused = [](const std::string& elements) {
    return refusal([&] { parse_ply("ply\nformat ascii 1.0\n" + elements + "end_header\n", "x.ply"); });
  };
  EXPECT_EQ(refused("element vertex 20000001\nproperty float x\n"),
            "x.ply: more than 20000000 elements 'vertex'");
  EXPECT_EQ(refused("element face 40000001\nproperty list uchar int vertex_indices\n"),
            "x.ply: more than 40000000 elements 'face'");
}

TEST(Limits, OfAnStlByItsCount) {
  const std::string header(80, ' ');
  EXPECT_EQ(refusal([&] { parse_stl(header + std::string("\x01\x5A\x62\x02", 4), "x.stl"); }),
            "x.stl: at byte 80: more than 40000000 triangles");
}

TEST(Limits, OfAFileByItsSizeBeforeItIsRead) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "flexkey_large_file";
  std::ofstream(path) << "v 0 0 0\n";
  std::filesystem::resize_file(path, limits::file_bytes + 1);  // a hole, which takes no room
  EXPECT_EQ(refusal([&] { read_file(path); }),
            "cannot read '" + path.string() + "': it is larger than 4294967296 bytes");
  std::filesystem::remove(path);
}

TEST(Limits, OfAStreamThatNeverEnds) {
  EXPECT_EQ(refusal([&] { read_file("/dev/zero", 1000); }),
            "cannot read '/dev/zero': it is larger than 1000 bytes");
  EXPECT_EQ(read_file("/dev/null", 0), "");
}

}  // namespace
}  // namespace flexkey
