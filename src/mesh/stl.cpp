#include "flexkey/mesh/stl.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <vector>

#include "flexkey/mesh/byte_words.h"
#include "flexkey/mesh/error.h"
#include "flexkey/mesh/limits.h"
#include "flexkey/mesh/numbers.h"
#include "flexkey/mesh/read_file.h"
#include "flexkey/mesh/text_words.h"
#include "flexkey/mesh/weld.h"

namespace flexkey {
namespace {

constexpr std::size_t header_bytes = 80, triangle_bytes = 50;
constexpr std::size_t most_triangles = limits::faces;

/// Triangles with a vertex for each of their corners.
struct Soup {
  std::vector<double> coordinates;
  std::vector<Group> groups;

  int triangle_count() const { return static_cast<int>(coordinates.size() / 9); }
};

Mesh welded(Soup soup) {
  Mesh mesh;
  const int count = soup.triangle_count();
  mesh.positions = Eigen::Map<const Positions>(soup.coordinates.data(), 3 * Eigen::Index{count}, 3);
  for (int f = 0; f < count; ++f) mesh.add_face(std::array{3 * f, 3 * f + 1, 3 * f + 2});
  mesh.groups = std::move(soup.groups);
  return weld(mesh).surface;
}

/// Of a binary STL, which says how long it is; texts may begin with the same word as its header.
bool is_binary(std::string_view bytes) {
  if (!bytes.starts_with("solid")) return true;
  if (bytes.size() < header_bytes + 4) return false;
  ByteWords count(bytes.substr(header_bytes), "", std::endian::little);
  return bytes.size() == header_bytes + 4 + count.bits(4, "") * triangle_bytes;
}

Soup read_binary(std::string_view bytes, const std::string& name) {
  ByteWords words(bytes, name, std::endian::little);
  words.skip(header_bytes, "the header of an STL");
  const std::uint64_t count = words.bits(4, "the count of triangles");
  if (count > most_triangles) words.fail(limits::more_than(most_triangles, "triangles"));
  if (count * triangle_bytes > words.bytes_left())
    words.fail(fmt::format("the file is too short for {} triangles", count));
  Soup soup;
  soup.coordinates.reserve(9 * count);
  for (std::uint64_t f = 0; f < count; ++f) {
    const std::string what = fmt::format("triangle {}", f);
    words.skip(12, what);  // its normal
    for (int k = 0; k < 9; ++k) {
      const double value = words.float32(what);
      if (const std::string_view fault = coordinate_fault(value); !fault.empty())
        words.fail(fmt::format("{} has the coordinate '{}', {}", what, value, fault));
      soup.coordinates.push_back(value);
    }
    words.skip(2, what);  // its attributes
  }
  return soup;
}

void expect(TextWords& words, std::string_view word) {
  const std::string_view found = words.next(fmt::format("'{}'", word));
  if (found != word) words.fail(fmt::format("'{}' stands where '{}' should", found.substr(0, 32), word));
}

/// A facet, whose first word has been read.
void read_facet(TextWords& words, Soup& soup) {
  const std::string what = fmt::format("triangle {}", soup.triangle_count());
  expect(words, "normal");
  for (int k = 0; k < 3; ++k) words.number("a normal");  // some are nan
  expect(words, "outer");
  expect(words, "loop");
  for (int corner = 0; corner < 3; ++corner) {
    expect(words, "vertex");
    for (int k = 0; k < 3; ++k) soup.coordinates.push_back(words.coordinate(what));
  }
  expect(words, "endloop");
  expect(words, "endfacet");
}

Soup read_text(std::string_view text, const std::string& name) {
  TextWords words(text, name, TextWords::Comments::none);
  Soup soup;
  std::map<std::string, std::size_t, std::less<>> group_of;  // by the name of a solid
  while (!words.at_end()) {
    expect(words, "solid");
    const std::string solid(words.rest_of_line());
    for (std::string_view word = words.next("'facet'"); word != "endsolid"; word = words.next("'facet'")) {
      if (word != "facet") words.fail(fmt::format("'{}' stands where 'facet' should", word.substr(0, 32)));
      if (soup.triangle_count() == limits::faces) words.fail(limits::more_than(limits::faces, "triangles"));
      if (!solid.empty()) {
        const auto [group, is_new] = group_of.try_emplace(solid, soup.groups.size());
        if (is_new) soup.groups.push_back({solid, {}});
        soup.groups[group->second].faces.push_back(soup.triangle_count());
      }
      read_facet(words, soup);
    }
    words.rest_of_line();  // the name again
  }
  return soup;
}

}  // namespace

MeshFile parse_stl(std::string_view bytes, const std::string& name) {
  Soup soup = is_binary(bytes) ? read_binary(bytes, name) : read_text(bytes, name);
  if (soup.triangle_count() == 0) throw InputError(fmt::format("{}: no faces in it", name));
  MeshFile file;
  file.mesh = welded(std::move(soup));
  return file;
}

MeshFile read_stl(const std::filesystem::path& path) {
  return parse_stl(read_file(path), path.string());
}

}  // namespace flexkey
