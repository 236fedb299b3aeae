#include "flexkey/mesh/off.h"

#include <fmt/format.h>

#include <limits>
#include <vector>

#include "flexkey/mesh/limits.h"
#include "flexkey/mesh/read_file.h"
#include "flexkey/mesh/text_words.h"

namespace flexkey {
namespace {

constexpr long long most = std::numeric_limits<int>::max();

/// What stands behind the coordinates of each vertex: nothing for a plain OFF.
bool has_more_a_vertex(TextWords& words) {
  const std::string_view format = words.next("'OFF'");
  if (format == "4OFF" || format == "nOFF" || format == "4nOFF")
    words.fail(fmt::format("a mesh of '{}' is not one of three dimensions", format));
  if (!format.ends_with("OFF")) words.fail("an OFF file begins with 'OFF'");
  return format != "OFF";
}

/// Refuses counts beyond the limits, or that the file is too short for: a vertex takes 6 bytes or more, a
/// face 7.
void require_room(const TextWords& words, long long vertices, long long faces) {
  if (vertices > limits::vertices) words.fail(limits::more_than(limits::vertices, "vertices"));
  if (faces > limits::faces) words.fail(limits::more_than(limits::faces, "faces"));
  const auto left = static_cast<long long>(words.bytes_left()) + 1;
  if (vertices > left / 6 || faces > left / 7)
    words.fail(fmt::format("the file is too short for {} vertices and {} faces", vertices, faces));
}

void read_vertices(TextWords& words, long long count, bool has_more, Mesh& mesh) {
  mesh.positions.resize(count, 3);
  for (long long v = 0; v < count; ++v) {
    const std::string what = fmt::format("vertex {}", v);
    for (int k = 0; k < 3; ++k) mesh.positions(v, k) = words.coordinate(what);
    if (has_more) words.rest_of_line();
  }
}

void read_faces(TextWords& words, long long count, Mesh& mesh) {
  std::vector<int> corners;
  for (long long f = 0; f < count; ++f) {
    const long long size = words.whole(fmt::format("the corner count of face {}", f), 3, most);
    if (std::ssize(mesh.corners) + size > limits::corners)
      words.fail(limits::more_than(limits::corners, "corners"));
    if (static_cast<std::size_t>(size) > words.bytes_left() / 2 + 1)
      words.fail(fmt::format("the file is too short for the {} corners of face {}", size, f));
    const std::string what = fmt::format("a vertex of face {}", f);
    corners.clear();
    for (long long k = 0; k < size; ++k)
      corners.push_back(static_cast<int>(words.whole(what, 0, mesh.vertex_count())));
    mesh.add_face(corners);
    words.rest_of_line();  // a colour
  }
}

}  // namespace

MeshFile parse_off(std::string_view text, const std::string& name) {
  TextWords words(text, name, TextWords::Comments::hash);
  const bool has_more = has_more_a_vertex(words);
  if (!words.at_end() && text.find("BINARY") < 20) words.fail("a binary OFF cannot be read; save it as text");
  const long long vertices = words.whole("the count of vertices", 0, most);
  const long long faces = words.whole("the count of faces", 0, most);
  words.whole("the count of edges", std::numeric_limits<long long>::min(), most);  // often not counted
  require_room(words, vertices, faces);
  MeshFile file;
  read_vertices(words, vertices, has_more, file.mesh);
  read_faces(words, faces, file.mesh);
  if (file.mesh.face_count() == 0) words.fail("no faces in it");
  if (!words.at_end()) words.fail("the file goes on behind its last face");
  return file;
}

MeshFile read_off(const std::filesystem::path& path) {
  return parse_off(read_file(path), path.string());
}

}  // namespace flexkey
