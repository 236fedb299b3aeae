#include "flexkey/mesh/ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "flexkey/mesh/byte_words.h"
#include "flexkey/mesh/error.h"
#include "flexkey/mesh/limits.h"
#include "flexkey/mesh/numbers.h"
#include "flexkey/mesh/ply_header.h"
#include "flexkey/mesh/read_file.h"
#include "flexkey/mesh/text_words.h"

namespace flexkey {
namespace {

using Kind = PlyType::Kind;

/// The data of a PLY, number after number.
class PlyData {
 public:
  PlyData(std::string_view data, const PlyHeader& header, const std::string& name)
      : words_(TextWords(data, name, TextWords::Comments::none, header.lines + 1)) {
    if (header.format == PlyFormat::text) return;
    const bool is_big = header.format == PlyFormat::big_endian;
    words_ = ByteWords(data, name, is_big ? std::endian::big : std::endian::little, header.bytes);
  }

  double number(PlyType type, std::string_view what) {
    if (auto* text = std::get_if<TextWords>(&words_)) return text->number(what);
    return stored(std::get<ByteWords>(words_), type, what);
  }

  /// Refuses a count of things that the rest of the file is too short for.
  void require_room(std::size_t count, std::size_t bytes_each, std::string_view what) const {
    const bool is_text = std::holds_alternative<TextWords>(words_);
    const std::size_t left = std::visit([](const auto& words) { return words.bytes_left(); }, words_);
    // Of a text the last number needs no blank behind it.
    if (bytes_each > 0 && count > (left + (is_text ? 1 : 0)) / bytes_each)
      fail(fmt::format("the file is too short for {}", what));
  }

  /// The least that an element takes in the file.
  std::size_t least_bytes(const PlyElement& element) const {
    const bool is_text = std::holds_alternative<TextWords>(words_);
    std::size_t bytes = 0;
    for (const PlyProperty& property : element.properties)
      bytes += is_text ? 2 : property.is_list ? property.count_type.bytes : property.type.bytes;
    return bytes;
  }
  std::size_t bytes_of(PlyType type) const {
    return std::holds_alternative<TextWords>(words_) ? 2 : type.bytes;
  }

  [[noreturn]] void fail(std::string_view message) const {
    if (const auto* text = std::get_if<TextWords>(&words_)) text->fail(message);
    std::get<ByteWords>(words_).fail(message);
  }

 private:
  static double stored(ByteWords& bytes, PlyType type, std::string_view what) {
    if (type.kind == Kind::floating) return type.bytes == 4 ? bytes.float32(what) : bytes.float64(what);
    const auto bits = static_cast<std::int64_t>(bytes.bits(type.bytes, what));
    const std::int64_t range = std::int64_t{1} << (8 * type.bytes);
    return static_cast<double>(type.kind == Kind::whole && bits >= range / 2 ? bits - range : bits);
  }

  std::variant<TextWords, ByteWords> words_;
};

class PlyParser {
 public:
  PlyParser(std::string_view bytes, const std::string& name)
      : name_(name),
        header_(read_ply_header(bytes, name)),
        data_(bytes.substr(header_.bytes), header_, name) {}
  MeshFile read();

 private:
  std::vector<int> columns_of(const PlyElement& element) const;
  void read_vertices(const PlyElement& element);
  void read_faces(const PlyElement& element);
  void pass_over(const PlyElement& element);
  void require_within_limits(const PlyElement& element) const;
  const std::vector<double>& numbers(const PlyProperty& property, const std::string& what);
  void add_face(const std::vector<double>& corners, const std::string& what);
  void add_texcoords(const std::vector<double>& numbers, const std::string& what);
  double finite(double value, std::string_view what) const;

  std::string name_;
  PlyHeader header_;
  PlyData data_;
  MeshFile file_;
  std::vector<double> numbers_;    // of the property read last
  std::vector<double> texcoords_;  // of corners
  std::size_t vertex_count_ = 0;
  bool has_vertex_texcoords_ = false;
};

MeshFile PlyParser::read() {
  for (const PlyElement& element : header_.elements)
    if (element.name == "vertex") vertex_count_ = element.count;
  for (const PlyElement& element : header_.elements) {
    require_within_limits(element);
    data_.require_room(element.count, data_.least_bytes(element),
                       fmt::format("{} elements '{}'", element.count, element.name));
    if (element.name == "vertex") {
      read_vertices(element);
    } else if (element.name == "face") {
      read_faces(element);
    } else {
      pass_over(element);
    }
  }
  Mesh& mesh = file_.mesh;
  if (mesh.face_count() == 0) throw InputError(fmt::format("{}: no faces in it", name_));
  if (!texcoords_.empty()) {
    mesh.texcoords =
        Eigen::Map<const TexCoords>(texcoords_.data(), static_cast<Eigen::Index>(texcoords_.size() / 2), 2);
  } else if (has_vertex_texcoords_) {
    mesh.corner_texcoord = mesh.corners;
  }
  return std::move(file_);
}

void PlyParser::require_within_limits(const PlyElement& element) const {
  const std::size_t most = element.name == "vertex" ? limits::vertices : limits::faces;
  if (element.count > most)
    throw InputError(
        fmt::format("{}: {}", name_, limits::more_than(most, fmt::format("elements '{}'", element.name))));
}

/// The items of a list, or the one number of another property; good until the next are read.
const std::vector<double>& PlyParser::numbers(const PlyProperty& property, const std::string& what) {
  double count = 1;
  if (property.is_list) count = data_.number(property.count_type, what);
  if (count < 0 || count != std::floor(count) || count > std::numeric_limits<int>::max())
    data_.fail(fmt::format("{} has a list of {} items", what, count));
  data_.require_room(static_cast<std::size_t>(count), data_.bytes_of(property.type),
                     fmt::format("the {} items '{}' of {}", count, property.name, what));
  numbers_.clear();
  for (int k = 0; k < static_cast<int>(count); ++k) numbers_.push_back(data_.number(property.type, what));
  return numbers_;
}

double PlyParser::finite(double value, std::string_view what) const {
  if (const std::string_view fault = coordinate_fault(value); !fault.empty())
    data_.fail(fmt::format("{} has the coordinate '{}', {}", what, value, fault));
  return value;
}

/// The names of x, y and z, and of the texture coordinates, in the order of their columns.
int column_of(const PlyProperty& property) {
  constexpr std::array<std::array<std::string_view, 3>, 5> names = {
      {{"x", "x", "x"}, {"y", "y", "y"}, {"z", "z", "z"}, {"s", "u", "texture_u"}, {"t", "v", "texture_v"}}};
  for (std::size_t column = 0; column < names.size() && !property.is_list; ++column)
    if (std::find(names[column].begin(), names[column].end(), property.name) != names[column].end())
      return static_cast<int>(column);
  return -1;
}

/// Of the element's properties; those that stand for nothing here have -1. Throws InputError where x, y or z
/// is missing.
std::vector<int> PlyParser::columns_of(const PlyElement& element) const {
  std::vector<int> columns;
  for (const PlyProperty& property : element.properties) columns.push_back(column_of(property));
  for (const int needed : {0, 1, 2})
    if (std::find(columns.begin(), columns.end(), needed) == columns.end())
      throw InputError(fmt::format("{}: its vertices lack x, y or z", name_));
  return columns;
}

void PlyParser::read_vertices(const PlyElement& element) {
  const std::vector<int> columns = columns_of(element);
  const auto has = [&](int column) {
    return std::find(columns.begin(), columns.end(), column) != columns.end();
  };
  has_vertex_texcoords_ = has(3) && has(4);
  const auto rows = static_cast<Eigen::Index>(element.count);
  Mesh& mesh = file_.mesh;
  mesh.positions.resize(rows, 3);
  if (has_vertex_texcoords_) mesh.texcoords.resize(rows, 2);
  for (Eigen::Index v = 0; v < rows; ++v) {
    const std::string what = fmt::format("vertex {}", v);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const std::vector<double>& values = numbers(element.properties[k], what);
      const int column = columns[k];
      if (column >= 0 && column < 3) mesh.positions(v, column) = finite(values[0], what);
      if (column >= 3 && has_vertex_texcoords_) mesh.texcoords(v, column - 3) = finite(values[0], what);
    }
  }
}

void PlyParser::add_face(const std::vector<double>& corners, const std::string& what) {
  if (corners.size() < 3)
    data_.fail(fmt::format("{} has {} corners; at least 3 are needed", what, corners.size()));
  if (file_.mesh.corners.size() + corners.size() > std::size_t{limits::corners})
    data_.fail(limits::more_than(limits::corners, "corners"));
  std::vector<int> vertices;
  for (const double corner : corners) {
    const bool is_there = corner >= 0 && corner < static_cast<double>(vertex_count_);
    if (!is_there || corner != std::floor(corner))
      data_.fail(fmt::format("{} uses vertex {}, but there are {}", what, corner, vertex_count_));
    vertices.push_back(static_cast<int>(corner));
  }
  file_.mesh.add_face(vertices);
}

/// A pair of numbers a corner of the face added last, or none.
void PlyParser::add_texcoords(const std::vector<double>& numbers, const std::string& what) {
  Mesh& mesh = file_.mesh;
  const std::size_t corners = mesh.corners.size() - mesh.corner_texcoord.size();
  if (!numbers.empty() && numbers.size() != 2 * corners)
    data_.fail(fmt::format("{} has {} corners and {} numbers of texture coordinates", what, corners,
                           numbers.size()));
  for (std::size_t k = 0; k < corners; ++k)
    mesh.corner_texcoord.push_back(numbers.empty() ? -1 : static_cast<int>(texcoords_.size() / 2 + k));
  for (const double number : numbers) texcoords_.push_back(finite(number, what));
}

void PlyParser::read_faces(const PlyElement& element) {
  const auto is_corners = [](const PlyProperty& property) {
    return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
  };
  const auto is_texcoords = [](const PlyProperty& property) {
    return property.is_list && property.name == "texcoord";
  };
  const auto& properties = element.properties;
  if (std::none_of(properties.begin(), properties.end(), is_corners))
    throw InputError(fmt::format("{}: its faces have no list 'vertex_indices'", name_));
  const bool has_texcoords = std::any_of(properties.begin(), properties.end(), is_texcoords);
  std::vector<double> texcoords;
  for (std::size_t f = 0; f < element.count; ++f) {
    const std::string what = fmt::format("face {}", f);
    texcoords.clear();
    for (const PlyProperty& property : properties) {
      const std::vector<double>& values = numbers(property, what);
      if (is_corners(property)) add_face(values, what);
      if (is_texcoords(property)) texcoords = values;
    }
    if (has_texcoords) add_texcoords(texcoords, what);
  }
}

void PlyParser::pass_over(const PlyElement& element) {
  for (std::size_t k = 0; k < element.count && !element.properties.empty(); ++k)
    for (const PlyProperty& property : element.properties)
      numbers(property, fmt::format("element {} of '{}'", k, element.name));
  if (element.count > 0)
    file_.warnings.push_back(
        fmt::format("{}: {} elements '{}' are passed over", name_, element.count, element.name));
}

}  // namespace

MeshFile parse_ply(std::string_view bytes, const std::string& name) {
  return PlyParser(bytes, name).read();
}

MeshFile read_ply(const std::filesystem::path& path) {
  return parse_ply(read_file(path), path.string());
}

}  // namespace flexkey
