#include <algorithm>
#include <bit>
#include <cstdint>

#include "flexkey/mesh/connectivity.h"
#include "flexkey/mesh/defects.h"
#include "flexkey/mesh/error.h"
#include "flexkey/mesh/limits.h"
#include "flexkey/mesh/mtl.h"
#include "flexkey/mesh/obj.h"
#include "flexkey/mesh/off.h"
#include "flexkey/mesh/ply.h"
#include "flexkey/mesh/stl.h"
#include "flexkey/mesh/weld.h"
#include "fuzz/check_mesh.h"
#include "fuzz/targets.h"

namespace flexkey::fuzz {
namespace {

template <class Read>
void run_reader(Read read) {
  try {
    check_mesh(read().mesh);
  } catch (const Error&) {
    // Refused, as it may be.
  }
}

template <class Number>
std::string bytes_of(std::endian order, const std::vector<Number>& numbers) {
  std::string bytes;
  for (const Number number : numbers) {
    std::string one(reinterpret_cast<const char*>(&number), sizeof number);
    if (order != std::endian::native) std::reverse(one.begin(), one.end());
    bytes += one;
  }
  return bytes;
}

/// A triangle and a further element, in one of the binary forms.
std::string binary_ply(std::endian order, const std::string& name) {
  std::string bytes =
      "ply\nformat binary_" + name + " 1.0\nelement vertex 3\n" +
      "property float x\nproperty double y\nproperty float z\nproperty uchar red\n" +
      "element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n" +
      "element edge 1\nproperty short a\nend_header\n";
  for (int v = 0; v < 3; ++v) {
    bytes += bytes_of<float>(order, {static_cast<float>(v)});
    bytes += bytes_of<double>(order, {v * 0.5});
    bytes += bytes_of<float>(order, {static_cast<float>(v * v)});
    bytes += '\x7F';
  }
  bytes += '\3' + bytes_of<std::int32_t>(order, {0, 1, 2});
  bytes += '\6' + bytes_of<float>(order, {0, 0, 1, 0, 1, 1});
  return bytes + bytes_of<std::int16_t>(order, {-1});
}

}  // namespace

void check_mesh(const Mesh& mesh) {
  promise(mesh.face_count() > 0 && mesh.face_count() <= limits::faces, "faces within the limits");
  promise(mesh.vertex_count() <= limits::vertices, "vertices within the limits");
  promise(mesh.positions.allFinite(), "finite positions");
  for (const int v : mesh.corners) promise(v >= 0 && v < mesh.vertex_count(), "corners name vertices");
  for (int f = 0; f < mesh.face_count(); ++f) promise(mesh.face(f).size() >= 3, "faces have three corners");
  for (const int row : mesh.corner_texcoord)
    promise(row >= -1 && row < mesh.texcoords.rows(), "corners name texture coordinates");
  for (const int material : mesh.face_material)
    promise(material >= -1 && material < std::ssize(mesh.materials), "faces name materials");
  for (const Group& group : mesh.groups)
    for (const int f : group.faces) promise(f >= 0 && f < mesh.face_count(), "groups name faces");
  // What comes next of it.
  const Weld welded = weld(mesh);
  describe(find_defects(welded.surface));
  boundary_loops(welded.surface);
  promise(vertex_normals(mesh, mesh.positions).allFinite(), "finite normals");
}

void run_obj(std::string_view bytes) {
  run_reader([&] { return parse_obj(bytes, "x.obj", "/nowhere"); });
}
void run_ply(std::string_view bytes) {
  run_reader([&] { return parse_ply(bytes, "x.ply"); });
}
void run_off(std::string_view bytes) {
  run_reader([&] { return parse_off(bytes, "x.off"); });
}
void run_stl(std::string_view bytes) {
  run_reader([&] { return parse_stl(bytes, "x.stl"); });
}

void run_mtl(std::string_view bytes) {
  for (const Material& material : parse_mtl(std::string(bytes)))
    promise(material.base_color.allFinite() && material.opacity >= 0 && material.opacity <= 1,
            "colours and opacities from 0 to 1");
}

std::vector<std::string> ply_seeds() {
  return {binary_ply(std::endian::little, "little_endian"), binary_ply(std::endian::big, "big_endian")};
}

std::vector<std::string> stl_seeds() {
  std::string bytes(80, ' ');
  bytes += bytes_of<std::uint32_t>(std::endian::little, {2});
  for (int f = 0; f < 2; ++f) {
    bytes += bytes_of<float>(std::endian::little, {0, 0, 1, 0, 0, 0, 1, 0, 0, static_cast<float>(f), 1, 0});
    bytes += std::string(2, '\0');
  }
  return {bytes};
}

}  // namespace flexkey::fuzz
