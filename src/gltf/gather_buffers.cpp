#include "flexkey/gltf/gather_buffers.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "flexkey/gltf/float_rows.h"
#include "flexkey/gltf/json_fields.h"
#include "flexkey/gltf/meshopt_view.h"
#include "flexkey/gltf/resource.h"
#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

using nlohmann::json;
using Bytes = std::vector<unsigned char>;

constexpr const char* kMeshopt = "EXT_meshopt_compression";

/// A range of a buffer, as a view or an extension of it names one.
struct Range {
  std::size_t buffer = 0, offset = 0, length = 0;
};

class Gathering {
 public:
  Gathering(const Glb& document, const std::filesystem::path& folder)
      : folder_(folder), root_(json::parse(document.json)), chunk_(document.bytes) {}
  Gathered gather();

 private:
  void read_buffers();
  Bytes read_buffer(const json& buffer, std::size_t number);
  Range range_of(const json& object, const std::string& what) const;
  void check_views();
  void join_buffers();
  void unpack_views();
  Bytes decoded(const json& compression, const std::string& what) const;
  void embed_images();
  void embed_image(json& image, std::size_t number);
  std::size_t append(std::span<const unsigned char> bytes);
  void describe_buffer();
  bool is_compressed() const;

  const std::filesystem::path& folder_;
  json root_;
  const Bytes& chunk_;
  std::vector<Bytes> buffers_;
  std::vector<bool> is_fallback_;  // #buffers; one that only clients without the extension would read
  Gathered result_;
};

Gathered Gathering::gather() {
  read_buffers();
  check_views();
  if (is_compressed()) {
    unpack_views();
  } else {
    join_buffers();
  }
  buffers_.clear();
  embed_images();
  describe_buffer();
  result_.document.json = root_.dump();
  return std::move(result_);
}

void Gathering::check_views() {
  const auto& views = list_at(root_, "bufferViews", "the file");
  for (std::size_t v = 0; v < views.size(); ++v) {
    const std::string what = fmt::format("buffer view {}", v);
    if (find_extension(views[v], kMeshopt, what) == nullptr) range_of(views[v], what);
  }
}

void Gathering::read_buffers() {
  const auto& buffers = list_at(root_, "buffers", "the file");
  for (std::size_t b = 0; b < buffers.size(); ++b) buffers_.push_back(read_buffer(buffers[b], b));
}

Bytes Gathering::read_buffer(const json& buffer, std::size_t number) {
  const std::string what = fmt::format("buffer {}", number);
  const std::size_t length = require_count(buffer, "byteLength", what);
  const std::string uri = text_at(buffer, "uri", what);
  const json* meshopt = find_extension(buffer, kMeshopt, what);
  is_fallback_.push_back(uri.empty() && meshopt != nullptr && meshopt->value("fallback", false));
  if (is_fallback_.back()) return {};

  Bytes bytes;
  if (uri.empty()) {
    if (number > 0 || chunk_.empty()) throw InputError(fmt::format("{} is missing: it has no 'uri'", what));
    bytes = chunk_;
  } else {
    try {
      Resource resource = read_resource(uri, folder_);
      bytes = std::move(resource.bytes);
      if (!resource.path.empty()) result_.inputs.push_back(resource.path);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{} ('{:.60}') cannot be read: {}", what, uri, error.what()));
    }
  }
  if (bytes.size() < length)
    throw InputError(fmt::format("{} has {} bytes, and its 'byteLength' is {}", what, bytes.size(), length));
  bytes.resize(length);  // a GLB's chunk may be padded
  return bytes;
}

/// Of a view or the compression of one. Throws where it is out of bounds.
Range Gathering::range_of(const json& object, const std::string& what) const {
  Range range;
  range.buffer = static_cast<std::size_t>(require_index(object, "buffer", buffers_.size(), what));
  range.offset = find_count(object, "byteOffset", what).value_or(0);
  range.length = require_count(object, "byteLength", what);
  const std::size_t size = buffers_[range.buffer].size();
  if (is_fallback_[range.buffer]) throw InputError(fmt::format("{} is of a buffer without data", what));
  if (range.offset > size || range.length > size - range.offset)
    throw InputError(fmt::format("{} reaches beyond its buffer: {} bytes from {} on, of {}", what,
                                 range.length, range.offset, size));
  return range;
}

bool Gathering::is_compressed() const {
  const auto& views = list_at(root_, "bufferViews", "the file");
  return std::any_of(views.begin(), views.end(), [](const json& view) {
    return find_extension(view, kMeshopt, "a buffer view") != nullptr;
  });
}

std::size_t Gathering::append(std::span<const unsigned char> bytes) {
  Bytes& all = result_.document.bytes;
  all.resize(static_cast<std::size_t>(aligned(static_cast<std::int64_t>(all.size()))));
  const std::size_t offset = all.size();
  all.insert(all.end(), bytes.begin(), bytes.end());
  return offset;
}

/// The buffers one behind the other.
void Gathering::join_buffers() {
  std::vector<std::size_t> starts;
  for (Bytes& buffer : buffers_) {
    if (starts.empty()) {
      result_.document.bytes = std::move(buffer);
      starts.push_back(0);
    } else {
      starts.push_back(append(buffer));
    }
  }
  if (!root_.contains("bufferViews")) return;
  for (json& view : root_["bufferViews"]) {
    const std::size_t start = starts[view["buffer"].get<std::size_t>()];
    view["buffer"] = 0;
    if (start > 0) view["byteOffset"] = start + view.value("byteOffset", std::size_t{0});
  }
}

/// The views one behind the other, so that nothing of the compressed data stays.
void Gathering::unpack_views() {
  std::size_t number = 0;
  for (json& view : root_["bufferViews"]) {
    const std::string what = fmt::format("buffer view {}", number++);
    if (const json* compression = find_extension(view, kMeshopt, what); compression != nullptr) {
      const Bytes bytes = decoded(*compression, what);
      view["byteOffset"] = append(bytes);
      view["byteLength"] = bytes.size();
      view["extensions"].erase(kMeshopt);
      if (view["extensions"].empty()) view.erase("extensions");
    } else {
      const Range range = range_of(view, what);
      view["byteOffset"] = append(std::span(buffers_[range.buffer]).subspan(range.offset, range.length));
    }
    view["buffer"] = 0;
  }
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
    if (!root_.contains(list)) continue;
    json kept = json::array();
    for (const json& name : list_at(root_, list, "the file"))
      if (name != kMeshopt) kept.push_back(name);
    root_[list] = kept;
    if (kept.empty()) root_.erase(list);
  }
}

Bytes Gathering::decoded(const json& compression, const std::string& what) const {
  const std::string extension = fmt::format("{} of {}", kMeshopt, what);
  const Range range = range_of(compression, extension);
  MeshoptView view;
  view.mode = text_at(compression, "mode", extension);
  view.filter = text_at(compression, "filter", extension);
  if (view.filter.empty()) view.filter = "NONE";
  view.count = require_count(compression, "count", extension);
  view.stride = require_count(compression, "byteStride", extension);
  try {
    return decode_meshopt(std::span(buffers_[range.buffer]).subspan(range.offset, range.length), view);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{} cannot be read: {}", extension, error.what()));
  }
}

void Gathering::embed_images() {
  if (list_at(root_, "images", "the file").empty()) return;
  // Made first, since a new member moves the others.
  if (!root_.contains("bufferViews")) root_["bufferViews"] = json::array();
  std::size_t number = 0;
  for (json& image : root_["images"]) embed_image(image, number++);
  if (root_["bufferViews"].empty()) root_.erase("bufferViews");
}

void Gathering::embed_image(json& image, std::size_t number) {
  const std::string what = fmt::format("image {}", number);
  const std::string uri = text_at(image, "uri", what);
  if (uri.empty()) return;
  try {
    const Resource resource = read_resource(uri, folder_);
    const std::string type = image_type_of(resource.bytes);
    if (type.empty() && !image.contains("mimeType")) throw InputError("its format is unknown");
    if (!resource.path.empty()) result_.inputs.push_back(resource.path);
    const std::size_t offset = append(resource.bytes);
    image.erase("uri");
    if (!type.empty()) image["mimeType"] = type;
    image["bufferView"] = root_["bufferViews"].size();
    root_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", resource.bytes.size()}});
  } catch (const InputError& error) {
    result_.warnings.push_back(fmt::format("{} ('{:.60}') stays outside: {}", what, uri, error.what()));
  }
}

/// What the file says of buffer 0 is kept.
void Gathering::describe_buffer() {
  const std::size_t length = result_.document.bytes.size();
  json buffer = root_.contains("buffers") && !root_["buffers"].empty() ? root_["buffers"][0] : json::object();
  root_.erase("buffers");
  if (length == 0) return;
  buffer.erase("uri");
  buffer["byteLength"] = length;
  root_["buffers"] = json::array({std::move(buffer)});
}

}  // namespace

Gathered gather_buffers(const Glb& document, const std::filesystem::path& folder) {
  return Gathering(document, folder).gather();
}

}  // namespace flexkey
