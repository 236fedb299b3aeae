#include "flexkey/mesh/ply.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/read_mesh.h"

namespace flexkey {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string positions = "property double x\nproperty double y\nproperty double z\n";
const std::string corner_list = "property list uchar int vertex_indices\n";

std::string header(const std::string& format, int vertices, const std::string& more_a_vertex, int faces,
                   const std::string& more_a_face = "") {
  return fmt::format(
      "ply\nformat {} 1.0\ncomment made by a test\nelement vertex {}\n{}{}element face {}\n{}{}end_header\n",
      format, vertices, positions, more_a_vertex, faces, corner_list, more_a_face);
}

/// Numbers one behind another in one byte order.
class Packed {
 public:
  explicit Packed(const std::string& format) : is_big_(format == "binary_big_endian") {}
  template <class Number>
  Packed& add(Number number) {
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    if (is_big_) std::reverse(bytes.begin(), bytes.end());
    bytes_ += bytes;
    return *this;
  }
  Packed& add_point(double x, double y, double z) { return add(x).add(y).add(z); }
  const std::string& bytes() const { return bytes_; }

 private:
  bool is_big_;
  std::string bytes_;
};

Mesh parse(const std::string& bytes) {
  return parse_ply(bytes, "x.ply").mesh;
}

std::string error_of(const std::string& bytes) {
  try {
    parse(bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const std::string square = "0 0 0\n1 0 0\n1 1 0.1\n0 1 0\n";

TEST(Ply, KeepsPolygonsAndVertexOrder) {
  const Mesh mesh = parse(header("ascii", 5, "", 2) + square + "2 0.5 0\n4 0 1 2 3\n3 1 4 2");
  EXPECT_EQ(mesh.vertex_count(), 5);
  EXPECT_EQ(mesh.positions(2, 2), 0.1);
  EXPECT_THAT(mesh.face(0), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(mesh.face(1), ElementsAre(1, 4, 2));
  EXPECT_TRUE(mesh.corner_texcoord.empty());
}

TEST(Ply, BothByteOrdersHoldTheSame) {
  const std::string properties = "property uchar red\nproperty short mood\n";
  const Mesh text = parse(header("ascii", 4, properties, 1, "property float weight\n") +
                          "0 0 0 255 -3\n1 0 0 0 0\n1 1 0.1 0 0\n0 1 0 0 0\n4 3 2 1 0 0.5\n");
  for (const char* format : {"binary_little_endian", "binary_big_endian"}) {
    Packed data(format);
    for (const auto& p : text.positions.rowwise())
      data.add_point(p[0], p[1], p[2]).add(std::uint8_t{200}).add(std::int16_t{-3});
    data.add(std::uint8_t{4});
    for (const int v : text.corners) data.add(std::int32_t{v});
    data.add(0.5F);
    const Mesh mesh = parse(header(format, 4, properties, 1, "property float weight\n") + data.bytes());
    EXPECT_EQ(mesh.positions, text.positions);
    EXPECT_EQ(mesh.corners, text.corners);
  }
}

TEST(Ply, TheDataBeginsBehindOneEndOfLine) {
  Packed data("binary_little_endian");
  // The first number's first byte is 10, an end of line.
  data.add(std::uint64_t{0x3FF000000000000AU}).add(0.0).add(0.0).add_point(2, 0, 0).add_point(0, 1, 0);
  data.add(std::uint8_t{3}).add(0).add(1).add(2);
  const std::string head = header("binary_little_endian", 3, "", 1);
  EXPECT_EQ(parse(head + data.bytes()).positions(0, 0), 1 + 10 * 0x1p-52);
  std::string windows;
  for (const char byte : head) windows += byte == '\n' ? std::string("\r\n") : std::string(1, byte);
  EXPECT_EQ(parse(windows + data.bytes()).positions(0, 0), 1 + 10 * 0x1p-52);
}

TEST(Ply, TexturesOfVerticesAndOfCorners) {
  const Mesh vertices = parse(header("ascii", 3, "property float s\nproperty float t\n", 1) +
                              "0 0 0 0.25 0.5\n1 0 0 1 0\n0 1 0 0 1\n3 2 0 1\n");
  EXPECT_EQ(vertices.texcoords.row(0), Eigen::RowVector2d(0.25, 0.5));
  EXPECT_THAT(vertices.corner_texcoord, ElementsAre(2, 0, 1));
  // A seam: the common edge has other coordinates on each side.
  const Mesh corners = parse(header("ascii", 4, "", 3, "property list uchar float texcoord\n") + square +
                             "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0.5 0 0.5 1 0 1\n3 0 1 3 0\n");
  EXPECT_EQ(corners.vertex_count(), 4);
  EXPECT_EQ(corners.texcoords.rows(), 6);
  EXPECT_THAT(corners.corner_texcoord, ElementsAre(0, 1, 2, 3, 4, 5, -1, -1, -1));
  EXPECT_EQ(corners.texcoords.row(3), Eigen::RowVector2d(0.5, 0));
}

TEST(Ply, OtherElementsArePassedOver) {
  const MeshFile file = parse_ply(
      "ply\nformat ascii 1.0\nelement edge 2\nproperty list uint8 uint ends\nproperty float w\nelement "
      "vertex 3\n" +
          positions + "element face 1\nproperty list uchar uint vertex_index\nend_header\n" +
          "2 0 1 0.5\n0 7\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
      "x.ply");
  EXPECT_EQ(file.mesh.positions(1, 0), 1);
  EXPECT_THAT(file.warnings, ElementsAre("x.ply: 2 elements 'edge' are passed over"));
}

TEST(Ply, AWrongHeaderIsAnErrorWithItsLine) {
  EXPECT_EQ(error_of(""), "x.ply:1: a PLY file begins with 'ply'");
  EXPECT_EQ(error_of("ply\nformat ascii 2.0\n"), "x.ply:2: version 2.0 is not known, 1.0 is");
  EXPECT_EQ(error_of("ply\nformat utf8 1.0\n"), "x.ply:2: unknown format 'utf8'");
  EXPECT_EQ(error_of("ply\nformat ascii 1.0\nelement vertex -1\n"),
            "x.ply:3: the count of 'vertex' is -1, outside 0..2147483646");
  EXPECT_EQ(error_of("ply\nproperty float x\n"), "x.ply:2: a property stands before any element");
  EXPECT_EQ(error_of("ply\nelement vertex 1\nproperty real x\n"), "x.ply:3: unknown type 'real'");
  EXPECT_EQ(error_of("ply\nelement face 1\nproperty list float int x\n"),
            "x.ply:3: a list has a whole number of items");
  EXPECT_EQ(error_of("ply\nvertices 3\n"), "x.ply:2: 'vertices' has no meaning in the header of a PLY");
  EXPECT_EQ(error_of("ply\nend_header\n"), "x.ply:2: the header names no format");
  EXPECT_EQ(error_of("ply\nformat ascii 1.0\n"), "x.ply:3: the file ends where 'end_header' should stand");
  EXPECT_EQ(error_of("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n"),
            "x.ply: its vertices lack x, y or z");
  EXPECT_EQ(error_of("ply\nformat ascii 1.0\nelement face 1\nproperty int a\nend_header\n0\n"),
            "x.ply: its faces have no list 'vertex_indices'");
}

TEST(Ply, WrongDataIsAnErrorWithItsPlace) {
  const std::string head = header("ascii", 4, "", 1);  // of 10 lines
  EXPECT_EQ(error_of(head + square + "4 0 1 2 4\n"), "x.ply:15: face 0 uses vertex 4, but there are 4");
  EXPECT_THAT(error_of(head + square + "4 0 1 2 -1\n"), HasSubstr("face 0 uses vertex -1"));
  EXPECT_THAT(error_of(head + square + "4 0 1 2 1.5\n"), HasSubstr("face 0 uses vertex 1.5"));
  EXPECT_THAT(error_of(head + square + "2 0 1 \n      "), HasSubstr("face 0 has 2 corners"));
  EXPECT_THAT(error_of(head + square + "-4 0 1 2 3\n"), HasSubstr("face 0 has a list of -4 items"));
  EXPECT_THAT(error_of(head + square + "40 0 1 2 3\n"), HasSubstr("too short for the 40 items"));
  EXPECT_EQ(error_of(head + "0 0 0\n1 0 x\n1 1 0\n0 1 0\n4 0 1 2 3\n"),
            "x.ply:12: 'x' is no number, and vertex 1 should stand there");
  EXPECT_EQ(error_of(head + "0 0 0\n1 0 nan\n1 1 0\n0 1 0\n4 0 1 2 3\n"),
            "x.ply:12: vertex 1 has the coordinate 'nan', which is not a finite number");
  EXPECT_EQ(error_of(header("ascii", 20000000, "", 1) + square),
            "x.ply:11: the file is too short for 20000000 elements 'vertex'");
  EXPECT_EQ(error_of(head + square), "x.ply:15: the file ends where face 0 should stand");
  EXPECT_THAT(error_of(header("ascii", 4, "", 0) + square), HasSubstr("no faces in it"));
}

TEST(Ply, ACutBinaryIsAnErrorWithItsByte) {
  const std::string head = header("binary_big_endian", 3, "", 1);
  Packed data("binary_big_endian");
  data.add_point(0, 0, 0).add_point(1, 0, 0).add_point(0, 1, 0).add(std::uint8_t{3}).add(0).add(1).add(2);
  EXPECT_EQ(error_of(head + data.bytes()), "no error");
  for (std::size_t size = 0; size < data.bytes().size(); ++size)
    EXPECT_THAT(error_of(head + data.bytes().substr(0, size)), HasSubstr("x.ply: at byte ")) << size;
  Packed wrong("binary_big_endian");
  wrong.add_point(0, 0, 0).add_point(1, 0, 0).add_point(0, 1, 0).add(std::uint8_t{3}).add(0).add(1).add(3);
  EXPECT_EQ(
      error_of(head + wrong.bytes()),
      fmt::format("x.ply: at byte {}: face 0 uses vertex 3, but there are 3", head.size() + 72 + 1 + 8));
}

TEST(Ply, IsReadByItsName) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "square.PLY";
  std::ofstream(path, std::ios::binary) << header("ascii", 4, "", 1) << square << "4 0 1 2 3\n";
  EXPECT_EQ(read_mesh(path).mesh.face_count(), 1);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace flexkey
