#include "flexkey/gltf/meshopt.h"

#include <meshoptimizer.h>

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>

#include "flexkey/gltf/float_grid.h"
#include "flexkey/gltf/float_rows.h"
#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

using nlohmann::json;
using Bytes = std::vector<unsigned char>;

constexpr const char* kExtension = "EXT_meshopt_compression";
constexpr int kTriangleTarget = 34963;  // ELEMENT_ARRAY_BUFFER
constexpr int kFloat = 5126;
constexpr std::size_t kLargestStride = 256;

/// What a buffer view holds, as the extension tells it.
struct Stream {
  std::size_t count = 0, stride = 0;
  bool triangles = false, floats = false;
};

std::size_t component_bytes(int type) {
  return type == 5120 || type == 5121 ? 1 : type == 5122 || type == 5123 ? 2 : 4;
}

std::size_t components(const std::string& type) {
  static const std::map<std::string, std::size_t> counts = {
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  const auto found = counts.find(type);
  return found == counts.end() ? 0 : found->second;
}

/// Views of indices that make no lists of triangles: the codec for those would turn a strip's corners about.
std::set<std::size_t> strips_of(const json& asset) {
  constexpr int triangles = 4;
  std::set<std::size_t> views;
  for (const json& mesh : asset.value("meshes", json::array()))
    for (const json& primitive : mesh.value("primitives", json::array())) {
      if (primitive.value("mode", triangles) == triangles || !primitive.contains("indices")) continue;
      const json& indices = asset["accessors"][primitive["indices"].get<std::size_t>()];
      if (indices.contains("bufferView")) views.insert(indices["bufferView"].get<std::size_t>());
    }
  return views;
}

/// Views of which some accessor reads other numbers than floats, such as joints beside positions.
std::set<std::size_t> integer_views_of(const json& asset) {
  std::set<std::size_t> views;
  for (const json& accessor : asset.value("accessors", json::array()))
    if (accessor.contains("bufferView") && accessor["componentType"] != kFloat)
      views.insert(accessor["bufferView"].get<std::size_t>());
  return views;
}

/// The stream of each buffer view that one accessor fills from its start to its end.
std::map<std::size_t, Stream> streams_of(const json& asset) {
  const std::set<std::size_t> strips = strips_of(asset), integers = integer_views_of(asset);
  std::map<std::size_t, Stream> streams;
  for (const json& accessor : asset.value("accessors", json::array())) {
    if (!accessor.contains("bufferView") || accessor.contains("sparse")) continue;
    const std::size_t index = accessor["bufferView"];
    if (strips.contains(index)) continue;
    const json& view = asset["bufferViews"][index];
    const std::size_t element = component_bytes(accessor["componentType"]) * components(accessor["type"]);
    const Stream stream{accessor["count"], view.value("byteStride", element),
                        view.value("target", 0) == kTriangleTarget, !integers.contains(index)};
    if (stream.count * stream.stride == view["byteLength"]) streams[index] = stream;
  }
  return streams;
}

Bytes encoded_triangles(const unsigned char* data, const Stream& stream) {
  std::vector<unsigned int> corners(stream.count);
  for (std::size_t i = 0; i < stream.count; ++i) {
    std::memcpy(&corners[i], data + i * stream.stride, stream.stride);
  }
  std::size_t vertices = 0;
  for (const unsigned int corner : corners) vertices = std::max<std::size_t>(vertices, corner + 1);
  Bytes code(meshopt_encodeIndexBufferBound(corners.size(), vertices));
  code.resize(meshopt_encodeIndexBuffer(code.data(), code.size(), corners.data(), corners.size()));
  return code;
}

Bytes encoded_rows(const unsigned char* data, const Stream& stream) {
  Bytes code(meshopt_encodeVertexBufferBound(stream.count, stream.stride));
  code.resize(meshopt_encodeVertexBuffer(code.data(), code.size(), data, stream.count, stream.stride));
  return code;
}

/// A view's code, and the extension's filter that makes it what it was.
struct Code {
  Bytes bytes;
  const char* filter = nullptr;
};

/// The view's bytes encoded, where the codec takes them and they get smaller.
std::optional<Code> encoded(std::span<const unsigned char> raw, const Stream& stream) {
  if (stream.count == 0) return std::nullopt;
  const bool fits = stream.triangles ? stream.count % 3 == 0 && (stream.stride == 2 || stream.stride == 4)
                                     : stream.stride % 4 == 0 && stream.stride <= kLargestStride;
  if (!fits) return std::nullopt;
  Code code;
  if (stream.triangles) {
    code.bytes = encoded_triangles(raw.data(), stream);
  } else if (const std::optional<Bytes> integers = stream.floats ? grid_integers(raw) : std::nullopt) {
    code = {encoded_rows(integers->data(), stream), "EXPONENTIAL"};
  } else {
    code.bytes = encoded_rows(raw.data(), stream);
  }
  return code.bytes.size() < raw.size() ? std::optional(std::move(code)) : std::nullopt;
}

void append(Bytes& bytes, std::span<const unsigned char> more) {
  bytes.resize(static_cast<std::size_t>(aligned(static_cast<std::int64_t>(bytes.size()))));
  bytes.insert(bytes.end(), more.begin(), more.end());
}

std::size_t next_offset(const Bytes& bytes) {
  return static_cast<std::size_t>(aligned(static_cast<std::int64_t>(bytes.size())));
}

void require_extension(json& asset) {
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) asset[list].push_back(kExtension);
}

}  // namespace

Glb meshopt_compressed(const Glb& glb) {
  meshopt_encodeVertexVersion(0);
  meshopt_encodeIndexVersion(1);
  json asset = json::parse(glb.json);
  const std::map<std::size_t, Stream> streams = streams_of(asset);
  Glb result;
  std::size_t decoded_bytes = 0;  // of the buffer that only exists once decoded
  for (std::size_t index = 0; index < asset["bufferViews"].size(); ++index) {
    json& view = asset["bufferViews"][index];
    const std::size_t offset = view.value("byteOffset", std::size_t{0}), length = view["byteLength"];
    const std::span<const unsigned char> raw = std::span(glb.bytes).subspan(offset, length);
    const auto stream = streams.find(index);
    const std::optional<Code> code = stream == streams.end() ? std::nullopt : encoded(raw, stream->second);
    const std::size_t place = next_offset(result.bytes);
    append(result.bytes, code ? std::span<const unsigned char>(code->bytes) : raw);
    if (!code) {
      view["byteOffset"] = place;
      continue;
    }
    view["extensions"][kExtension] = {{"buffer", 0},
                                      {"byteOffset", place},
                                      {"byteLength", code->bytes.size()},
                                      {"byteStride", stream->second.stride},
                                      {"mode", stream->second.triangles ? "TRIANGLES" : "ATTRIBUTES"},
                                      {"count", stream->second.count}};
    if (code->filter != nullptr) view["extensions"][kExtension]["filter"] = code->filter;
    view["buffer"] = 1;
    view["byteOffset"] = decoded_bytes;
    decoded_bytes += static_cast<std::size_t>(aligned(static_cast<std::int64_t>(length)));
  }
  asset["buffers"][0]["byteLength"] = result.bytes.size();
  if (decoded_bytes > 0) {
    asset["buffers"].push_back(
        {{"byteLength", decoded_bytes}, {"extensions", {{kExtension, {{"fallback", true}}}}}});
    require_extension(asset);
  }
  result.json = asset.dump();
  return result;
}

}  // namespace flexkey
