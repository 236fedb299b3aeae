#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "flexkey/mesh/types.h"

namespace flexkey::meshes {

/// Puts a glTF file together piece by piece; a test may change `root` as it likes.
class GltfBuilder {
 public:
  using json = nlohmann::json;

  json root = {{"asset", {{"version", "2.0"}}}};
  std::string bytes;  // of buffer 0

  /// Appends a thing to a list of the file and returns its index.
  int add(const char* list, json thing) {
    root[list].push_back(std::move(thing));
    return static_cast<int>(root[list].size()) - 1;
  }

  int add_view(std::string_view data, json more = json::object()) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    more.update({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size()}});
    bytes += data;
    return add("bufferViews", std::move(more));
  }

  template <class Number>
  int add_view(const std::vector<Number>& numbers, json more = json::object()) {
    return add_view({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)},
                    std::move(more));
  }

  /// An accessor of these numbers, `columns` an element, with min and max.
  template <class Number>
  int add_accessor(const std::vector<Number>& numbers, std::size_t columns, json more = json::object()) {
    more["bufferView"] = add_view(numbers);
    more.update(described(numbers, columns));
    return add("accessors", std::move(more));
  }

  int add_points(const std::vector<Vec3>& points) { return add_accessor(floats_of(points), 3); }

  int add_indices(const std::vector<std::uint16_t>& indices) {
    const int accessor = add_accessor(indices, 1);
    return accessor;
  }

  /// What an accessor says of its elements.
  template <class Number>
  static json described(const std::vector<Number>& numbers, std::size_t columns) {
    const std::size_t count = numbers.size() / columns;
    std::vector<Number> low(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(columns)),
        high = low;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      low[i % columns] = std::min(low[i % columns], numbers[i]);
      high[i % columns] = std::max(high[i % columns], numbers[i]);
    }
    const std::string type = columns == 1    ? "SCALAR"
                             : columns == 16 ? "MAT4"
                                             : "VEC" + std::to_string(columns);
    return {{"componentType", component_type(Number{})},
            {"count", count},
            {"type", type},
            {"min", low},
            {"max", high}};
  }

  static std::vector<float> floats_of(const std::vector<Vec3>& points) {
    std::vector<float> floats;
    for (const Vec3& point : points)
      for (int i = 0; i < 3; ++i) floats.push_back(static_cast<float>(point[i]));
    return floats;
  }

  /// The file as a GLB; with its buffer described unless the test has done so.
  std::string glb() const {
    json described = root;
    if (!described.contains("buffers") && !bytes.empty())
      described["buffers"] = json::array({{{"byteLength", bytes.size()}}});
    return frame(described.dump(), bytes);
  }

  /// Any text and bytes as a GLB.
  static std::string frame(std::string text, std::string binary) {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4);
    std::string chunks = word(text.size()) + "JSON" + text;
    if (!binary.empty()) chunks += word(binary.size()) + std::string("BIN\0", 4) + binary;
    return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
  }

  std::filesystem::path save(const std::filesystem::path& path) const {
    std::ofstream(path, std::ios::binary) << glb();
    return path;
  }

 private:
  static std::string word(std::size_t number) {
    std::string text(4, '\0');
    for (int i = 0; i < 4; ++i) text[static_cast<std::size_t>(i)] = static_cast<char>(number >> (8 * i));
    return text;
  }
  static int component_type(std::int8_t) { return 5120; }
  static int component_type(std::uint8_t) { return 5121; }
  static int component_type(std::int16_t) { return 5122; }
  static int component_type(std::uint16_t) { return 5123; }
  static int component_type(std::uint32_t) { return 5125; }
  static int component_type(float) { return 5126; }
};

/// A tube around z from 0 to `rings`, radius 1, whose columns meet in a seam of texture coordinates: the
/// first and last column lie at the same places.
struct Tube {
  int columns = 8, rings = 6;

  std::vector<Vec3> points() const {
    return rows([](double angle, double z) { return Vec3(std::cos(angle), std::sin(angle), z); });
  }
  std::vector<Vec3> normals() const {
    return rows([](double angle, double) { return Vec3(std::cos(angle), std::sin(angle), 0); });
  }
  std::vector<float> texcoords() const {
    std::vector<float> uv;
    for (int ring = 0; ring <= rings; ++ring)
      for (int column = 0; column <= columns; ++column) {
        uv.push_back(static_cast<float>(column) / static_cast<float>(columns));
        uv.push_back(static_cast<float>(ring) / static_cast<float>(rings));
      }
    return uv;
  }
  std::vector<std::uint16_t> indices() const {
    std::vector<std::uint16_t> corners;
    for (int ring = 0; ring < rings; ++ring)
      for (int column = 0; column < columns; ++column) {
        const int a = ring * (columns + 1) + column, b = a + 1, c = b + columns + 1, d = a + columns + 1;
        for (const int corner : {a, b, c, a, c, d}) corners.push_back(static_cast<std::uint16_t>(corner));
      }
    return corners;
  }
  int vertex_count() const { return (columns + 1) * (rings + 1); }
  int face_count() const { return 2 * columns * rings; }

 private:
  template <class At>
  std::vector<Vec3> rows(At at) const {
    std::vector<Vec3> result;
    for (int ring = 0; ring <= rings; ++ring)
      for (int column = 0; column <= columns; ++column)
        result.push_back(at(2 * std::numbers::pi * (column % columns) / columns, ring));
    return result;
  }
};

/// A primitive of the tube with normals and texture coordinates.
inline GltfBuilder::json add_tube(GltfBuilder& file, const Tube& tube = {}) {
  GltfBuilder::json attributes = {{"POSITION", file.add_points(tube.points())},
                                  {"NORMAL", file.add_points(tube.normals())},
                                  {"TEXCOORD_0", file.add_accessor(tube.texcoords(), 2)}};
  return {{"attributes", attributes}, {"indices", file.add_indices(tube.indices())}};
}

/// A file of one node, "tube", that shows a tube in material "skin".
inline GltfBuilder tube_file() {
  GltfBuilder file;
  GltfBuilder::json primitive = add_tube(file);
  primitive["material"] = file.add("materials", {{"name", "skin"}});
  file.add("meshes", {{"name", "tube mesh"}, {"primitives", {primitive}}});
  file.add("nodes", {{"name", "tube"}, {"mesh", 0}});
  file.add("scenes", {{"nodes", {0}}});
  file.root["scene"] = 0;
  return file;
}

/// The tube with two targets of its own, of which the second carries normals, an animation of them, and
/// default weights.
inline GltfBuilder tube_with_targets() {
  GltfBuilder file = tube_file();
  std::vector<Vec3> up(static_cast<std::size_t>(Tube().vertex_count()), Vec3(0, 0, 1));
  GltfBuilder::json& mesh = file.root["meshes"][0];
  mesh["primitives"][0]["targets"] = {{{"POSITION", file.add_points(up)}},
                                      {{"POSITION", file.add_points(up)}, {"NORMAL", file.add_points(up)}}};
  mesh["weights"] = {0.25, 0.5};
  mesh["extras"] = {{"targetNames", {"f0001", "smile"}}};
  const int times = file.add_accessor(std::vector<float>{0, 1}, 1),
            values = file.add_accessor(std::vector<float>{0, 1, 1, 0}, 1);
  file.add("animations", {{"name", "Talk"},
                          {"samplers", {{{"input", times}, {"output", values}}}},
                          {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}});
  return file;
}

/// Two tubes in nodes that stretch, turn and mirror them.
inline GltfBuilder two_tubes() {
  GltfBuilder file;
  file.add("meshes", {{"primitives", {add_tube(file)}}});
  file.add("meshes", {{"primitives", {add_tube(file)}}});
  file.add("nodes", {{"mesh", 0}, {"scale", {2, 1, 0.5}}, {"rotation", {0.6, 0, 0, 0.8}}});
  file.add("nodes", {{"children", {2}}, {"translation", {5, 0, 0}}, {"scale", {-1, 3, 1}}});
  file.add("nodes", {{"mesh", 1}, {"translation", {0, 1, 0}}});
  file.add("scenes", {{"nodes", {0, 1}}});
  return file;
}

/// The tube on one bone, with a clip that moves the bone, and a node transform that a skin does not obey.
inline GltfBuilder skinned_tube() {
  GltfBuilder file = tube_file();
  const std::size_t count = static_cast<std::size_t>(Tube().vertex_count());
  std::vector<std::uint8_t> joints(4 * count, 0);
  std::vector<float> weights(4 * count, 0), identity(16, 0);
  for (std::size_t v = 0; v < count; ++v) weights[4 * v] = 1;
  for (std::size_t i = 0; i < 16; i += 5) identity[i] = 1;
  GltfBuilder::json& attributes = file.root["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = file.add_accessor(joints, 4);
  attributes["WEIGHTS_0"] = file.add_accessor(weights, 4);
  file.add("skins", {{"joints", {1}}, {"inverseBindMatrices", file.add_accessor(identity, 16)}});
  file.root["nodes"][0]["skin"] = 0;
  file.root["nodes"][0]["translation"] = {100, 0, 0};
  file.add("nodes", {{"name", "bone"}});
  file.root["scenes"][0]["nodes"] = {0, 1};
  const int times = file.add_accessor(std::vector<float>{0, 1}, 1),
            values = file.add_points({{0, 0, 0}, {1, 0, 0}});
  file.add("animations",
           {{"name", "Walk"},
            {"samplers", {{{"input", times}, {"output", values}}}},
            {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}});
  return file;
}

}  // namespace flexkey::meshes
