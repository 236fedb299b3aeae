#include "flexkey/gltf/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <span>

#include "flexkey/gltf/utf8.h"
#include "flexkey/mesh/limits.h"

namespace flexkey {
namespace {

std::string mime_type_of(std::span<const std::byte> bytes) {
  const auto starts_with = [&](std::string_view magic) {
    return bytes.size() > magic.size() &&
           std::equal(magic.begin(), magic.end(), bytes.begin(), [](char expected, std::byte found) {
             return static_cast<std::byte>(expected) == found;
           });
  };
  if (starts_with("\x89PNG\r\n\x1a\n")) return "image/png";
  return starts_with("\xff\xd8\xff") ? "image/jpeg" : "";
}

/// MTL files written on Windows have backslashes in their paths.
std::filesystem::path located(const std::string& texture, const std::filesystem::path& folder) {
  std::string name = texture;
  std::replace(name.begin(), name.end(), '\\', '/');
  return folder / name;
}

/// A texture, or what keeps it from being one.
struct Reading {
  Texture texture;
  std::string problem;  // empty when there is none
};

Reading read_texture(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {{}, "there is no such file"};
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size > limits::texture_bytes)
    return {{}, fmt::format("it is larger than {} MiB", limits::texture_bytes >> 20)};
  Texture texture{valid_utf8(path.stem().string()), "", std::vector<std::byte>(size)};
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(texture.bytes.data()), static_cast<std::streamsize>(size));
  if (!file) return {{}, "it cannot be read"};
  texture.mime_type = mime_type_of(texture.bytes);
  if (texture.mime_type.empty()) return {{}, "it is neither PNG nor JPEG"};
  return {std::move(texture), ""};
}

}  // namespace

TextureSet read_textures(const Mesh& mesh, const std::vector<Primitive>& primitives,
                         const std::filesystem::path& folder) {
  TextureSet set;
  std::map<std::filesystem::path, int> known;
  for (const Primitive& primitive : primitives) {
    set.of_primitive.push_back(-1);
    if (primitive.material < 0) continue;
    const Material& material = mesh.materials[static_cast<std::size_t>(primitive.material)];
    if (material.texture.empty()) continue;

    const std::filesystem::path path = located(material.texture, folder);
    std::string problem;
    if (primitive.texcoords.empty()) {
      problem = "its faces have no texture coordinates";
    } else if (!known.contains(path)) {
      Reading reading = read_texture(path);
      problem = reading.problem;
      if (problem.empty()) {
        known[path] = static_cast<int>(set.textures.size());
        set.textures.push_back(std::move(reading.texture));
      }
    }
    if (problem.empty()) {
      set.of_primitive.back() = known[path];
    } else {
      set.warnings.push_back(fmt::format("texture '{}' of material '{}' is left out: {}", path.string(),
                                         material.name, problem));
    }
  }
  return set;
}

}  // namespace flexkey
