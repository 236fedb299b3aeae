#include "flexkey/mesh/obj.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/mtl.h"
#include "flexkey/mesh/numbers.h"
#include "flexkey/mesh/obj_tags.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool is_file(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

// tinyobjloader takes `nan` and other words for 0 and tells no line numbers, so the OBJ itself is read here;
// its materials, with their many options, are left to that library (mtl.h).
class ObjParser {
 public:
  ObjParser(std::string name, std::filesystem::path folder, const limits::MeshSize& most)
      : name_(std::move(name)), folder_(std::move(folder)), most_(most), tags_(name_) {}

  void read(std::string_view text);
  MeshFile finish();

 private:
  void read_line(std::string_view line);
  void read_vertex();
  void read_texcoord();
  void read_face();
  int read_index(std::string_view text, std::size_t count, std::string_view what);
  void choose_groups();
  void choose_material();
  void load_libraries();

  std::string_view next_word();
  std::string_view rest_of_line();
  double next_number(std::string_view what);
  int group_of(std::string_view group_name);
  int material_of(std::string_view material_name);
  [[noreturn]] void fail(const std::string& message) const;

  std::string name_;
  std::filesystem::path folder_;
  limits::MeshSize most_;
  int line_ = 0;
  std::string_view left_;  // of the current line

  MeshFile file_;
  std::vector<double> positions_, texcoords_;
  std::map<std::string, int, std::less<>> group_by_name_, material_by_name_;
  std::vector<int> object_groups_, open_groups_;  // of the last `o` and the last `g`
  std::size_t group_faces_ = 0;
  int open_material_ = -1;
  std::vector<int> corners_, corner_texcoords_;  // of the face being read
  ObjTags tags_;
  std::map<std::string, int, std::less<>> passed_over_;
};

void ObjParser::fail(const std::string& message) const {
  throw InputError(fmt::format("{}:{}: {}", name_, line_, message));
}

void ObjParser::read(std::string_view text) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  std::string joined;  // a logical line that was continued with a backslash
  int lines = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    ++lines;
    if (joined.empty()) line_ = lines;  // a continued line is named by its first
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.ends_with('\\')) {
      joined.append(line.substr(0, line.size() - 1)).push_back(' ');
      continue;
    }
    if (joined.empty()) {
      read_line(line);
    } else {
      joined.append(line);
      read_line(joined);
      joined.clear();
    }
  }
  if (!joined.empty()) read_line(joined);
}

void ObjParser::read_line(std::string_view line) {
  left_ = line.substr(0, line.find('#'));
  const std::string_view keyword = next_word();
  if (keyword.empty() || keyword == "vn" || keyword == "s") return;
  if (keyword == "v") return read_vertex();
  if (keyword == "vt") return read_texcoord();
  if (keyword == "f" || keyword == "fo") return read_face();
  if (keyword == "g" || keyword == "o") {
    const bool is_object = keyword == "o";
    choose_groups();
    if (is_object) object_groups_ = std::exchange(open_groups_, {});
    return;
  }
  if (keyword == "usemtl") return choose_material();
  if (keyword == "mtllib") return load_libraries();
  if (keyword == "t" && tags_.add(left_, line_)) return;
  ++passed_over_[std::string(keyword.substr(0, 32))];
}

std::string_view ObjParser::next_word() {
  const std::size_t start = left_.find_first_not_of(" \t");
  if (start == std::string_view::npos) return left_ = {};
  left_.remove_prefix(start);
  const std::string_view word = left_.substr(0, left_.find_first_of(" \t"));
  left_.remove_prefix(word.size());
  return word;
}

std::string_view ObjParser::rest_of_line() {
  const std::size_t start = left_.find_first_not_of(" \t");
  if (start == std::string_view::npos) return {};
  const std::size_t end = left_.find_last_not_of(" \t");
  return left_.substr(start, end - start + 1);
}

double ObjParser::next_number(std::string_view what) {
  const std::string_view word = next_word();
  if (word.empty()) fail(fmt::format("{} has too few coordinates", what));
  const std::optional<double> value = number_of(word);
  if (const std::string_view fault = coordinate_fault(value); !fault.empty())
    fail(fmt::format("{} has the coordinate '{}', {}", what, word.substr(0, 32), fault));
  return *value;
}

void ObjParser::read_vertex() {
  if (positions_.size() / 3 >= most_.vertices) fail(limits::more_than(most_.vertices, "vertices"));
  const std::string what = fmt::format("vertex {}", positions_.size() / 3);
  for (int k = 0; k < 3; ++k) positions_.push_back(next_number(what));
}

void ObjParser::read_texcoord() {
  if (texcoords_.size() / 2 >= most_.corners) fail(limits::more_than(most_.corners, "texture coordinates"));
  const std::string what = fmt::format("texture coordinate {}", texcoords_.size() / 2);
  const double u = next_number(what);
  const double v = number_of(next_word()).value_or(0);  // a 1D texture gives u alone
  if (!std::isfinite(v)) fail(fmt::format("{} is not a finite number", what));
  texcoords_.insert(texcoords_.end(), {u, v});
}

/// An index from 1, or from the end where negative, as an index from 0.
int ObjParser::read_index(std::string_view text, std::size_t count, std::string_view what) {
  long long index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc() || end != text.data() + text.size())
    fail(fmt::format("'{}' is not {} index", text.substr(0, 32), what));
  const long long from_zero = index > 0 ? index - 1 : static_cast<long long>(count) + index;
  if (index == 0 || from_zero < 0 || from_zero >= static_cast<long long>(count))
    fail(fmt::format("face {} uses {} index {}, but there are {} so far", file_.mesh.face_count(), what,
                     index, count));
  return static_cast<int>(from_zero);
}

void ObjParser::read_face() {
  corners_.clear();
  corner_texcoords_.clear();
  for (std::string_view word = next_word(); !word.empty(); word = next_word()) {
    const std::size_t slash = word.find('/');
    corners_.push_back(read_index(word.substr(0, slash), positions_.size() / 3, "vertex"));
    std::string_view rest = slash == std::string_view::npos ? std::string_view() : word.substr(slash + 1);
    const std::string_view texcoord = rest.substr(0, rest.find('/'));
    corner_texcoords_.push_back(
        texcoord.empty() ? -1 : read_index(texcoord, texcoords_.size() / 2, "texture coordinate"));
  }
  if (corners_.size() < 3)
    fail(fmt::format("face {} has {} corners; at least 3 are needed", file_.mesh.face_count(),
                     corners_.size()));

  const int face = file_.mesh.face_count();
  if (static_cast<std::size_t>(face) >= most_.faces) fail(limits::more_than(most_.faces, "faces"));
  if (file_.mesh.corners.size() + corners_.size() > most_.corners)
    fail(limits::more_than(most_.corners, "corners"));
  file_.mesh.add_face(corners_);
  auto& texcoord_of = file_.mesh.corner_texcoord;
  texcoord_of.insert(texcoord_of.end(), corner_texcoords_.begin(), corner_texcoords_.end());
  file_.mesh.face_material.push_back(open_material_);
  for (const std::vector<int>* groups : {&object_groups_, &open_groups_})
    for (const int group : *groups) {
      std::vector<int>& faces = file_.mesh.groups[static_cast<std::size_t>(group)].faces;
      if (!faces.empty() && faces.back() == face) continue;  // `o a` and `g a` may be one group
      if (++group_faces_ > most_.group_faces) fail(limits::more_than(most_.group_faces, "faces in groups"));
      faces.push_back(face);
    }
}

int ObjParser::group_of(std::string_view group_name) {
  const auto found = group_by_name_.find(group_name);
  if (found != group_by_name_.end()) return found->second;
  const int index = static_cast<int>(file_.mesh.groups.size());
  file_.mesh.groups.push_back({std::string(group_name), {}});
  group_by_name_.emplace(group_name, index);
  return index;
}

void ObjParser::choose_groups() {
  open_groups_.clear();
  for (std::string_view word = next_word(); !word.empty(); word = next_word()) {
    const int group = group_of(word);
    open_groups_.push_back(group);
  }
}

int ObjParser::material_of(std::string_view material_name) {
  const auto found = material_by_name_.find(material_name);
  if (found != material_by_name_.end()) return found->second;
  const int index = static_cast<int>(file_.mesh.materials.size());
  Material material;
  material.name = material_name;
  file_.mesh.materials.push_back(material);
  material_by_name_.emplace(material_name, index);
  return index;
}

void ObjParser::choose_material() {
  const std::string_view material_name = rest_of_line();
  open_material_ = material_name.empty() ? -1 : material_of(material_name);
}

void ObjParser::load_libraries() {
  // A library's name may hold spaces; the line is one name where such a file is there.
  std::vector<std::string> names;
  if (is_file(folder_ / rest_of_line())) {
    names.emplace_back(rest_of_line());
  } else {
    for (std::string_view word = next_word(); !word.empty(); word = next_word()) names.emplace_back(word);
  }
  for (const std::string& library : names) {
    if (!is_file(folder_ / library)) {
      file_.warnings.push_back(
          fmt::format("{}:{}: no material library '{}'; its materials are grey", name_, line_, library));
      continue;
    }
    file_.inputs.push_back(folder_ / library);
    for (Material& material : read_mtl(folder_ / library))
      file_.mesh.materials[static_cast<std::size_t>(material_of(material.name))] = std::move(material);
  }
}

MeshFile ObjParser::finish() {
  Mesh& mesh = file_.mesh;
  if (mesh.face_count() == 0) throw InputError(fmt::format("{}: no faces in it", name_));
  mesh.positions =
      Eigen::Map<const Positions>(positions_.data(), static_cast<Eigen::Index>(positions_.size() / 3), 3);
  mesh.texcoords =
      Eigen::Map<const TexCoords>(texcoords_.data(), static_cast<Eigen::Index>(texcoords_.size() / 2), 2);
  if (texcoords_.empty()) mesh.corner_texcoord.clear();
  if (mesh.materials.empty()) mesh.face_material.clear();
  std::erase_if(mesh.groups, [](const Group& group) { return group.faces.empty(); });
  for (std::string& warning : tags_.put_on(mesh)) file_.warnings.push_back(std::move(warning));
  for (const auto& [keyword, count] : passed_over_)
    file_.warnings.push_back(fmt::format("{}: {} elements '{}' are passed over", name_, count, keyword));
  return std::move(file_);
}

}  // namespace

MeshFile parse_obj(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                   const limits::MeshSize& most) {
  ObjParser parser(name, folder, most);
  parser.read(text);
  return parser.finish();
}

MeshFile read_obj(const std::filesystem::path& path) {
  return parse_obj(read_file(path), path.string(), path.parent_path());
}

}  // namespace flexkey
