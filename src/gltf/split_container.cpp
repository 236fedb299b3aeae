#include "flexkey/gltf/split_container.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/limits.h"

namespace flexkey {
namespace {

using nlohmann::json;

constexpr std::string_view kMagic = "glTF";
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr std::size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;

std::uint32_t word_at(std::string_view file, std::size_t offset) {
  std::uint32_t word = 0;
  std::memcpy(&word, file.data() + offset, sizeof word);
  return word;
}

struct Chunk {
  std::uint32_t type = 0;
  std::string_view bytes;
};

Chunk chunk_at(std::string_view file, std::size_t offset, int number) {
  const std::size_t left = file.size() - offset;
  if (left < kChunkHeaderBytes)
    throw InputError(fmt::format("the file ends inside the header of chunk {}", number));
  const std::size_t length = word_at(file, offset);
  if (length > left - kChunkHeaderBytes)
    throw InputError(fmt::format("chunk {} has {} bytes, and the file ends after {}", number, length,
                                 left - kChunkHeaderBytes));
  return {word_at(file, offset + 4), file.substr(offset + kChunkHeaderBytes, length)};
}

Glb split_glb(std::string_view file) {
  if (file.size() < kHeaderBytes) throw InputError("the file ends inside the header of a GLB");
  if (const std::uint32_t version = word_at(file, 4); version != 2)
    throw InputError(fmt::format("it is a GLB of version {}; flexkey reads version 2", version));
  const std::size_t length = word_at(file, 8);
  if (length < kHeaderBytes)
    throw InputError(fmt::format("the GLB has {} bytes, fewer than its header", length));
  if (length > file.size())
    throw InputError(fmt::format("the GLB has {} bytes, and the file ends after {}", length, file.size()));
  const std::string_view glb = file.substr(0, length);

  const Chunk first = chunk_at(glb, kHeaderBytes, 0);
  if (first.type != kJsonChunk) throw InputError("chunk 0 of the GLB is not its JSON");
  Glb document{std::string(first.bytes), {}};
  const std::size_t second = kHeaderBytes + kChunkHeaderBytes + (first.bytes.size() + 3) / 4 * 4;
  if (second >= glb.size()) return document;
  const Chunk binary = chunk_at(glb, second, 1);
  if (binary.type != kBinaryChunk) return document;
  document.bytes.assign(binary.bytes.begin(), binary.bytes.end());
  return document;
}

/// The library's message without its own name and error number.
std::string plain_message(const json::exception& error) {
  const std::string message = error.what();
  const std::size_t end = message.find("] ");
  return end == std::string::npos ? message : message.substr(end + 2);
}

/// How deep lists and objects are nested. (The parser's own callback takes time by the square of a list.)
int depth_of(std::string_view text) {
  int depth = 0, deepest = 0;
  bool in_string = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (in_string) {
      if (c == '\\') ++at;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      deepest = std::max(deepest, ++depth);
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return deepest;
}

void check_json(const std::string& text) {
  if (depth_of(text) > limits::json_depth)
    throw InputError(fmt::format("its JSON is nested more than {} deep", limits::json_depth));
  json root;
  try {
    root = json::parse(text);
  } catch (const json::exception& error) {
    throw InputError(fmt::format("its JSON cannot be read: {}", plain_message(error)));
  }
  if (!root.is_object()) throw InputError("its JSON is not an object");
  const json asset = root.value("asset", json());
  const json version = asset.is_object() ? asset.value("version", json()) : json();
  if (!version.is_string() || !version.get<std::string>().starts_with("2."))
    throw InputError(fmt::format("its asset version is {}; flexkey reads glTF 2", version.dump()));
}

}  // namespace

Glb split_container(std::string_view file) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  Glb document;
  if (file.starts_with(kMagic)) {
    document = split_glb(file);
  } else {
    if (file.starts_with(byte_order_mark)) file.remove_prefix(byte_order_mark.size());
    const std::size_t start = file.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos || file[start] != '{')
      throw InputError("it is no glTF: it begins neither with 'glTF' nor with '{'");
    document.json = std::string(file);
  }
  check_json(document.json);
  return document;
}

}  // namespace flexkey
