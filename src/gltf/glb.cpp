#include "flexkey/gltf/glb.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <array>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>

#include "flexkey/gltf/size_estimate.h"
#include "flexkey/mesh/error.h"
#include "flexkey/mesh/output_file.h"

namespace flexkey {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942;   // "BIN"
constexpr std::uintmax_t kHeaderBytes = 12, kChunkHeaderBytes = 8;

std::uintmax_t padded(std::size_t bytes) {
  return static_cast<std::uintmax_t>(aligned(static_cast<std::int64_t>(bytes)));
}

using Put = std::function<void(std::string_view)>;

void put_words(const Put& put, std::initializer_list<std::uintmax_t> words) {
  for (const std::uintmax_t word : words) {
    const auto narrow = static_cast<std::uint32_t>(word);
    put({reinterpret_cast<const char*>(&narrow), sizeof narrow});
  }
}

void put_chunk(const Put& put, std::uint32_t type, std::string_view bytes, char filler) {
  const std::uintmax_t length = padded(bytes.size());
  put_words(put, {length, type});
  put(bytes);
  put(std::string(length - bytes.size(), filler));
}

}  // namespace

Glb glb_of(tinygltf::Model&& model) {
  Glb glb;
  glb.bytes.swap(model.buffers[0].data);  // tinygltf would write it out in base64
  std::ostringstream text;
  tinygltf::TinyGLTF writer;
  if (!writer.WriteGltfSceneToStream(&model, text, false, false))
    throw Error("tinygltf cannot write the model");
  nlohmann::json json = nlohmann::json::parse(std::move(text).str());
  json["buffers"] = {{{"byteLength", glb.bytes.size()}}};
  glb.json = json.dump();
  return glb;
}

void put_glb(const Glb& glb, const Put& put) {
  const std::uintmax_t total =
      kHeaderBytes + 2 * kChunkHeaderBytes + padded(glb.json.size()) + padded(glb.bytes.size());
  if (total > static_cast<std::uintmax_t>(kMostGlbBytes))
    throw InputError("the GLB would be larger than 4 GiB, which it cannot be");
  put_words(put, {kMagic, 2, total});
  put_chunk(put, kJsonChunk, glb.json, ' ');
  put_chunk(put, kBinChunk, {reinterpret_cast<const char*>(glb.bytes.data()), glb.bytes.size()}, '\0');
}

std::uintmax_t save_glb(const Glb& glb, const std::filesystem::path& path) {
  OutputFile file(path);
  put_glb(glb, [&](std::string_view bytes) { file.write(bytes); });
  file.commit();
  return file.bytes_written();
}

}  // namespace flexkey
