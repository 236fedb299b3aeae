#include "flexkey/gltf/read_accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <unordered_map>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF buffers are little-endian");

enum ComponentType : int {
  signed_byte = 5120,
  unsigned_byte = 5121,
  signed_short = 5122,
  unsigned_short = 5123,
  unsigned_int = 5125,
  float_number = 5126
};

// An accessor without bytes of its own is all zeros but for a few; this many elements a byte of the file is
// more than any animation needs, and keeps a small file from asking for all memory.
constexpr std::size_t kElementsAByte = 64;

std::size_t component_bytes(int type, const std::string& what) {
  switch (type) {
    case signed_byte:
    case unsigned_byte:
      return 1;
    case signed_short:
    case unsigned_short:
      return 2;
    case unsigned_int:
    case float_number:
      return 4;
    default:
      throw InputError(fmt::format("{} has components of type {}, which flexkey cannot read", what, type));
  }
}

template <class Component>
double component(const unsigned char* at, bool normalized) {
  Component value;
  std::memcpy(&value, at, sizeof value);
  const auto number = static_cast<double>(value);
  if (!normalized || std::is_floating_point_v<Component>) return number;
  return std::max(number / static_cast<double>(std::numeric_limits<Component>::max()), -1.0);
}

double component_at(const unsigned char* at, int type, bool normalized) {
  switch (type) {
    case signed_byte:
      return component<std::int8_t>(at, normalized);
    case unsigned_byte:
      return component<std::uint8_t>(at, normalized);
    case signed_short:
      return component<std::int16_t>(at, normalized);
    case unsigned_short:
      return component<std::uint16_t>(at, normalized);
    case unsigned_int:
      return component<std::uint32_t>(at, normalized);
    default:
      return component<float>(at, normalized);
  }
}

void require_index_type(int type, const std::string& what) {
  if (type != unsigned_byte && type != unsigned_short && type != unsigned_int)
    throw InputError(fmt::format("{} has indices of type {}, which is no unsigned integer", what, type));
}

}  // namespace

/// Where the elements of an accessor lie.
struct AccessorReader::Place {
  const unsigned char* first;
  std::size_t stride;
  const unsigned char* at(std::size_t element) const { return first + element * stride; }
};

AccessorReader::Place AccessorReader::place_of(const std::string& what, int view_index, std::size_t offset,
                                               std::size_t count, std::size_t element_bytes) const {
  const GltfView& view = scene_.views[static_cast<std::size_t>(view_index)];
  const std::size_t stride = view.stride > 0 ? view.stride : element_bytes;
  if (stride < element_bytes)
    throw InputError(fmt::format("{} has elements of {} bytes, and its buffer view a stride of {}", what,
                                 element_bytes, stride));
  const bool in_bytes = view.offset <= bytes_.size() && view.length <= bytes_.size() - view.offset;
  const std::size_t room = in_bytes && offset <= view.length ? view.length - offset : 0;
  const std::size_t fitting = room < element_bytes ? 0 : (room - element_bytes) / stride + 1;
  if (count > fitting)
    throw InputError(
        fmt::format("{} reaches beyond its buffer view: it has {} elements, and there is room for {}", what,
                    count, fitting));
  return {count == 0 ? nullptr : bytes_.data() + view.offset + offset, stride};
}

AccessorRows AccessorReader::rows(int index, int columns) const {
  const GltfAccessor& accessor = scene_.accessors[static_cast<std::size_t>(index)];
  const std::string what = fmt::format("accessor {}", index);
  if (accessor.columns != columns)
    throw InputError(fmt::format("{} has {} components an element, not {}", what, accessor.columns, columns));
  const std::size_t size = component_bytes(accessor.component_type, what);
  const auto width = static_cast<std::size_t>(columns);
  if (accessor.count > static_cast<std::size_t>(std::numeric_limits<int>::max()) / width)
    throw InputError(fmt::format("{} has {} elements, which is too many", what, accessor.count));
  if (accessor.view < 0 && accessor.count * width / kElementsAByte > bytes_.size())
    throw InputError(fmt::format("{} has {} elements and no bytes, in a file of {} bytes", what,
                                 accessor.count, bytes_.size()));

  AccessorRows rows;
  if (accessor.view < 0) {
    rows = AccessorRows::Zero(static_cast<Eigen::Index>(accessor.count), columns);
  } else {
    const Place found = place_of(what, accessor.view, accessor.offset, accessor.count, size * width);
    rows.resize(static_cast<Eigen::Index>(accessor.count), columns);
    for (std::size_t row = 0; row < accessor.count; ++row)
      for (std::size_t column = 0; column < width; ++column)
        rows(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
            component_at(found.at(row) + column * size, accessor.component_type, accessor.normalized);
  }
  for (const Replaced& other : replaced(what, accessor))
    for (std::size_t column = 0; column < width; ++column)
      rows(static_cast<Eigen::Index>(other.element), static_cast<Eigen::Index>(column)) =
          component_at(other.bytes + column * size, accessor.component_type, accessor.normalized);
  for (Eigen::Index row = 0; row < rows.rows(); ++row)
    if (!rows.row(row).allFinite())
      throw InputError(fmt::format("{} has a value at element {} that is not a finite number", what, row));
  return rows;
}

std::vector<AccessorReader::Replaced> AccessorReader::replaced(const std::string& what,
                                                               const GltfAccessor& accessor) const {
  if (!accessor.sparse) return {};
  const GltfSparse& sparse = *accessor.sparse;
  const std::string part = fmt::format("'sparse' of {}", what);
  require_index_type(sparse.index_type, part);
  const std::size_t index_size = component_bytes(sparse.index_type, part);
  const std::size_t size = component_bytes(accessor.component_type, part);
  const auto width = static_cast<std::size_t>(accessor.columns);
  const Place indices = place_of(part, sparse.index_view, sparse.index_offset, sparse.count, index_size);
  const Place values = place_of(part, sparse.value_view, sparse.value_offset, sparse.count, size * width);
  std::vector<Replaced> all;
  for (std::size_t at = 0; at < sparse.count; ++at) {
    const auto row = static_cast<std::size_t>(component_at(indices.at(at), sparse.index_type, false));
    if (row >= accessor.count)
      throw InputError(fmt::format("{} names element {} of {}", part, row, accessor.count));
    all.push_back({row, values.at(at)});
  }
  return all;
}

RawElements AccessorReader::elements(int index, const std::vector<int>& chosen) const {
  const GltfAccessor& accessor = scene_.accessors[static_cast<std::size_t>(index)];
  const std::string what = fmt::format("accessor {}", index);
  if (accessor.columns == 0)
    throw InputError(fmt::format("{} has matrices, which flexkey cannot copy", what));
  const std::size_t size = component_bytes(accessor.component_type, what);
  const auto width = static_cast<std::size_t>(accessor.columns);
  const std::vector<unsigned char> zeros(size * width, 0);
  const Place found = accessor.view < 0
                          ? Place{zeros.data(), 0}
                          : place_of(what, accessor.view, accessor.offset, accessor.count, zeros.size());
  std::unordered_map<std::size_t, const unsigned char*> others;
  for (const Replaced& one : replaced(what, accessor)) others[one.element] = one.bytes;

  RawElements raw{accessor.component_type, accessor.columns, accessor.normalized, {}, {}};
  raw.values.resize(static_cast<Eigen::Index>(chosen.size()), accessor.columns);
  const auto stride = static_cast<std::size_t>(aligned(static_cast<std::int64_t>(zeros.size())));
  raw.bytes.resize(chosen.size() * stride);
  for (std::size_t row = 0; row < chosen.size(); ++row) {
    const auto element = static_cast<std::size_t>(chosen[row]);
    if (element >= accessor.count)
      throw InputError(
          fmt::format("{} has {} elements, and a face names element {}", what, accessor.count, element));
    const auto other = others.find(element);
    const unsigned char* bytes = other == others.end() ? found.at(element) : other->second;
    std::memcpy(raw.bytes.data() + row * stride, bytes, zeros.size());
    for (std::size_t column = 0; column < width; ++column)
      raw.values(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
          component_at(bytes + column * size, accessor.component_type, false);
  }
  return raw;
}

std::vector<int> AccessorReader::indices(int index, std::size_t vertices) const {
  const GltfAccessor& accessor = scene_.accessors[static_cast<std::size_t>(index)];
  const std::string what = fmt::format("accessor {}", index);
  require_index_type(accessor.component_type, what);
  if (accessor.view < 0 || accessor.sparse || accessor.columns != 1)
    throw InputError(fmt::format("{} is not a plain list of indices", what));
  const std::size_t size = component_bytes(accessor.component_type, what);
  const Place found = place_of(what, accessor.view, accessor.offset, accessor.count, size);
  std::vector<int> result(accessor.count);
  for (std::size_t at = 0; at < accessor.count; ++at) {
    const double vertex = component_at(found.at(at), accessor.component_type, false);
    if (vertex >= static_cast<double>(vertices))
      throw InputError(fmt::format("{} names vertex {} of {}", what, vertex, vertices));
    result[at] = static_cast<int>(vertex);
  }
  return result;
}

}  // namespace flexkey
