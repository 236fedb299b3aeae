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

void write_words(OutputFile& file, std::initializer_list<std::uintmax_t> words) {
  for (const std::uintmax_t word : words) {
    const auto narrow = static_cast<std::uint32_t>(word);
    file.write(std::as_bytes(std::span(&narrow, 1)));
  }
}

void write_chunk(OutputFile& file, std::uint32_t type, std::span<const std::byte> bytes, char filler) {
  const std::uintmax_t length = padded(bytes.size());
  write_words(file, {length, type});
  file.write(bytes);
  file.write(std::string(length - bytes.size(), filler));
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

std::uintmax_t save_glb(const Glb& glb, const std::filesystem::path& path) {
  const std::uintmax_t total =
      kHeaderBytes + 2 * kChunkHeaderBytes + padded(glb.json.size()) + padded(glb.bytes.size());
  if (total > static_cast<std::uintmax_t>(kMostGlbBytes)) {
    throw InputError(fmt::format("'{}' would be larger than 4 GiB, which a GLB cannot be", path.string()));
  }
  OutputFile file(path);
  write_words(file, {kMagic, 2, total});
  write_chunk(file, kJsonChunk, std::as_bytes(std::span(glb.json)), ' ');
  write_chunk(file, kBinChunk, std::as_bytes(std::span(glb.bytes)), '\0');
  file.commit();
  return file.bytes_written();
}

}  // namespace flexkey
