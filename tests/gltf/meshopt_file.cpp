#include "gltf/meshopt_file.h"

#include <meshoptimizer.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace flexkey::testing {
namespace {

using nlohmann::json;

constexpr const char* extension_name = "EXT_meshopt_compression";

std::uint32_t word_at(const std::string& file, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, file.data() + at, sizeof(word));
  return word;
}

/// Decodes one view to where it stands in the buffer that is only there once decoded.
void decode(const json& view, const unsigned char* binary, std::vector<unsigned char>& decoded) {
  const json& code = view["extensions"][extension_name];
  const std::size_t count = code["count"], stride = code["byteStride"], length = code["byteLength"];
  const unsigned char* from = binary + code["byteOffset"].get<std::size_t>();
  const std::size_t to = view["byteOffset"];
  if (to + count * stride > decoded.size() || count * stride != view["byteLength"])
    throw std::runtime_error("a view does not fit its buffer");
  const int failure = code["mode"] == "TRIANGLES"
                          ? meshopt_decodeIndexBuffer(decoded.data() + to, count, stride, from, length)
                          : meshopt_decodeVertexBuffer(decoded.data() + to, count, stride, from, length);
  if (failure != 0) throw std::runtime_error("meshoptimizer cannot decode a view");
  const std::string filter = code.value("filter", "NONE");
  if (filter == "EXPONENTIAL") meshopt_decodeFilterExp(decoded.data() + to, count, stride);
  if (filter != "EXPONENTIAL" && filter != "NONE") throw std::runtime_error("unknown filter " + filter);
}

}  // namespace

tinygltf::Model load_meshopt_glb(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string file(std::istreambuf_iterator<char>(stream), {});
  const std::size_t json_length = word_at(file, 12);
  json asset = json::parse(file.substr(20, json_length));
  const auto* binary = reinterpret_cast<const unsigned char*>(file.data()) + 28 + json_length;
  std::vector<std::vector<unsigned char>> buffers;
  buffers.emplace_back(binary, binary + word_at(file, 20 + json_length));
  if (asset["buffers"].size() > 1) buffers.emplace_back(asset["buffers"][1]["byteLength"].get<std::size_t>());
  for (json& view : asset["bufferViews"]) {
    if (!view.contains("extensions")) continue;
    decode(view, binary, buffers[1]);
    view.erase("extensions");
  }
  for (json& buffer : asset["buffers"]) {
    buffer.erase("extensions");
    buffer["uri"] = "data:application/octet-stream;base64,AAAA";
    buffer["byteLength"] = 3;
  }
  tinygltf::TinyGLTF reader;
  tinygltf::Model model;
  std::string errors, warnings;
  const std::string text = asset.dump();
  if (!reader.LoadASCIIFromString(&model, &errors, &warnings, text.data(),
                                  static_cast<unsigned int>(text.size()), "."))
    throw std::runtime_error(errors);
  for (std::size_t i = 0; i < buffers.size(); ++i) model.buffers[i].data = std::move(buffers[i]);
  return model;
}

}  // namespace flexkey::testing
