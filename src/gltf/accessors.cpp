#include "flexkey/gltf/accessors.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

namespace flexkey {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF buffers are little-endian");

constexpr int kNoTarget = 0;

int append_view(tinygltf::Model& model, std::span<const std::byte> bytes, int target) {
  if (model.buffers.empty()) model.buffers.emplace_back();
  std::vector<unsigned char>& data = model.buffers[0].data;
  data.resize(static_cast<std::size_t>(aligned(static_cast<std::int64_t>(data.size()))));

  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = data.size();
  view.byteLength = bytes.size();
  view.target = target;
  const auto* first = reinterpret_cast<const unsigned char*>(bytes.data());
  data.insert(data.end(), first, first + bytes.size());

  model.bufferViews.push_back(std::move(view));
  return static_cast<int>(model.bufferViews.size()) - 1;
}

int add_accessor(tinygltf::Model& model, tinygltf::Accessor accessor) {
  model.accessors.push_back(std::move(accessor));
  return static_cast<int>(model.accessors.size()) - 1;
}

int type_of_columns(Eigen::Index columns) {
  constexpr int types[] = {TINYGLTF_TYPE_SCALAR, TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4};
  return types[columns - 1];
}

std::span<const std::byte> bytes_of(const FloatRows& rows) {
  return std::as_bytes(std::span(rows.data(), static_cast<std::size_t>(rows.size())));
}

std::vector<double> doubles(const Eigen::RowVectorXd& row) {
  return {row.begin(), row.end()};
}

/// An accessor of `count` rows whose values are these and, where some are left out, zeros.
tinygltf::Accessor float_accessor(const FloatRows& values, std::int64_t count) {
  tinygltf::Accessor accessor;
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
  accessor.type = type_of_columns(values.cols());
  accessor.count = static_cast<std::size_t>(count);
  Eigen::RowVectorXf low = values.colwise().minCoeff();
  Eigen::RowVectorXf high = values.colwise().maxCoeff();
  if (values.rows() < count) {
    low = low.cwiseMin(0.0F);
    high = high.cwiseMax(0.0F);
  }
  accessor.minValues = doubles(low.cast<double>());
  accessor.maxValues = doubles(high.cast<double>());
  return accessor;
}

int append_dense(tinygltf::Model& model, const FloatRows& rows, int target) {
  tinygltf::Accessor accessor = float_accessor(rows, rows.rows());
  accessor.bufferView = append_view(model, bytes_of(rows), target);
  return add_accessor(model, std::move(accessor));
}

template <typename Index>
int append_integers(tinygltf::Model& model, std::span<const std::uint32_t> integers, int target) {
  const std::vector<Index> narrow(integers.begin(), integers.end());
  return append_view(model, std::as_bytes(std::span(narrow)), target);
}

int append_sparse(tinygltf::Model& model, const SparseRows& rows) {
  tinygltf::Accessor accessor = float_accessor(rows.values, rows.count);
  accessor.sparse.isSparse = true;
  accessor.sparse.count = static_cast<int>(rows.indices.size());
  auto& indices = accessor.sparse.indices;
  indices.byteOffset = 0;
  switch (index_bytes(rows.indices.back())) {
    case 1:
      indices.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
      indices.bufferView = append_integers<std::uint8_t>(model, rows.indices, kNoTarget);
      break;
    case 2:
      indices.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
      indices.bufferView = append_integers<std::uint16_t>(model, rows.indices, kNoTarget);
      break;
    default:
      indices.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
      indices.bufferView = append_integers<std::uint32_t>(model, rows.indices, kNoTarget);
  }
  accessor.sparse.values.byteOffset = 0;
  accessor.sparse.values.bufferView = append_view(model, bytes_of(rows.values), kNoTarget);
  return add_accessor(model, std::move(accessor));
}

int append_smaller(tinygltf::Model& model, const SparseRows& rows, int dense_target) {
  const int columns = static_cast<int>(rows.values.cols());
  const auto kept = static_cast<std::int64_t>(rows.indices.size());
  if (sparse_bytes(kept, rows.indices.back(), columns) < dense_bytes(rows.count, columns)) {
    return append_sparse(model, rows);
  }
  return append_dense(model, dense_rows(rows), dense_target);
}

/// The rows' numbers in this many bytes each, a row padded to a multiple of 4.
std::vector<std::byte> strided(const ShortRows& rows, std::size_t number_bytes, std::size_t stride) {
  std::vector<std::byte> bytes(static_cast<std::size_t>(rows.rows()) * stride);
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    std::byte* to = bytes.data() + static_cast<std::size_t>(row) * stride;
    for (const std::int16_t number : rows.row(row)) {
      std::memcpy(to, &number, number_bytes);  // of a little-endian number the low bytes
      to += number_bytes;
    }
  }
  return bytes;
}

float number_at(const unsigned char* data, int component_type) {
  const auto read = [&]<typename T>(T value) {
    std::memcpy(&value, data, sizeof(T));
    return static_cast<float>(value);
  };
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return std::max(read(std::int8_t{0}) / 127.0F, -1.0F);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return std::max(read(std::int16_t{0}) / 32767.0F, -1.0F);
    default:
      return read(0.0F);
  }
}

const unsigned char* view_data(const tinygltf::Model& model, int view) {
  return model.buffers[0].data.data() + model.bufferViews[static_cast<std::size_t>(view)].byteOffset;
}

std::int64_t read_index(const unsigned char* data, int component_type, std::size_t at) {
  const auto bytes =
      static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_type)));
  std::uint32_t index = 0;
  std::memcpy(&index, data + at * bytes, bytes);
  return index;
}

}  // namespace

int append_attribute(tinygltf::Model& model, const FloatRows& rows) {
  return append_dense(model, rows, TINYGLTF_TARGET_ARRAY_BUFFER);
}

int append_elements(tinygltf::Model& model, const RawElements& elements) {
  const AccessorRows& values = elements.values;
  tinygltf::Accessor accessor;
  accessor.componentType = elements.component_type;
  accessor.type = type_of_columns(elements.columns);
  accessor.normalized = elements.normalized;
  accessor.count = static_cast<std::size_t>(values.rows());
  if (values.allFinite()) {
    accessor.minValues = doubles(values.colwise().minCoeff());
    accessor.maxValues = doubles(values.colwise().maxCoeff());
  }
  accessor.bufferView =
      append_view(model, std::as_bytes(std::span(elements.bytes)), TINYGLTF_TARGET_ARRAY_BUFFER);
  model.bufferViews.back().byteStride = elements.bytes.size() / accessor.count;
  return add_accessor(model, std::move(accessor));
}

int append_deltas(tinygltf::Model& model, const SparseRows& rows) {
  return append_smaller(model, rows, TINYGLTF_TARGET_ARRAY_BUFFER);
}

int append_normalized(tinygltf::Model& model, const ShortRows& rows, int largest) {
  const std::size_t number_bytes = largest <= INT8_MAX ? 1 : 2;
  const auto stride =
      static_cast<std::size_t>(aligned(rows.cols() * static_cast<Eigen::Index>(number_bytes)));
  tinygltf::Accessor accessor;
  accessor.componentType = number_bytes == 1 ? TINYGLTF_COMPONENT_TYPE_BYTE : TINYGLTF_COMPONENT_TYPE_SHORT;
  accessor.type = type_of_columns(rows.cols());
  accessor.normalized = true;
  accessor.count = static_cast<std::size_t>(rows.rows());
  accessor.minValues = doubles(rows.cast<double>().colwise().minCoeff());
  accessor.maxValues = doubles(rows.cast<double>().colwise().maxCoeff());
  accessor.bufferView = append_view(model, strided(rows, number_bytes, stride), TINYGLTF_TARGET_ARRAY_BUFFER);
  model.bufferViews.back().byteStride = stride;
  return add_accessor(model, std::move(accessor));
}

int append_times(tinygltf::Model& model, const FloatRows& times) {
  return append_dense(model, times, kNoTarget);
}

int append_values(tinygltf::Model& model, const FloatRows& values) {
  return append_dense(model, values, kNoTarget);
}

int append_samples(tinygltf::Model& model, const SparseRows& rows) {
  return append_smaller(model, rows, kNoTarget);
}

int append_triangles(tinygltf::Model& model, std::span<const std::uint32_t> corners) {
  const bool narrow = *std::max_element(corners.begin(), corners.end()) < UINT16_MAX;
  tinygltf::Accessor accessor;
  accessor.type = TINYGLTF_TYPE_SCALAR;
  accessor.count = corners.size();
  accessor.componentType =
      narrow ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  accessor.bufferView =
      narrow ? append_integers<std::uint16_t>(model, corners, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER)
             : append_integers<std::uint32_t>(model, corners, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  return add_accessor(model, std::move(accessor));
}

int append_bytes(tinygltf::Model& model, std::span<const std::byte> bytes) {
  return append_view(model, bytes, kNoTarget);
}

FloatRows read_rows(const tinygltf::Model& model, int index) {
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  const auto count = static_cast<Eigen::Index>(accessor.count);
  const int columns = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  FloatRows rows = FloatRows::Zero(count, columns);
  if (accessor.bufferView >= 0) {
    const unsigned char* data = view_data(model, accessor.bufferView);
    const int number_bytes =
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
    const int stride = accessor.ByteStride(model.bufferViews[static_cast<std::size_t>(accessor.bufferView)]);
    for (Eigen::Index row = 0; row < count; ++row) {
      for (Eigen::Index column = 0; column < columns; ++column) {
        rows(row, column) = number_at(data + row * stride + column * number_bytes, accessor.componentType);
      }
    }
  }
  if (!accessor.sparse.isSparse) return rows;
  const unsigned char* indices = view_data(model, accessor.sparse.indices.bufferView);
  const unsigned char* values = view_data(model, accessor.sparse.values.bufferView);
  const std::size_t row_bytes = static_cast<std::size_t>(columns) * sizeof(float);
  for (std::size_t at = 0; at < static_cast<std::size_t>(accessor.sparse.count); ++at) {
    const std::int64_t row = read_index(indices, accessor.sparse.indices.componentType, at);
    std::memcpy(rows.row(row).data(), values + at * row_bytes, row_bytes);
  }
  return rows;
}

}  // namespace flexkey
