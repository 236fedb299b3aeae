#include "gltf/glb_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace flexkey::testing {
namespace {

std::size_t component_bytes(int type) {
  return static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type)));
}

double component(const std::vector<unsigned char>& data, std::size_t at, int type) {
  const auto read = [&]<typename T>(T value) {
    if (at + sizeof(T) > data.size()) throw std::out_of_range("the buffer ends before the accessor");
    std::memcpy(&value, data.data() + at, sizeof(T));
    return static_cast<double>(value);
  };
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return read(0.0F);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return read(std::int16_t{0});
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return read(std::int8_t{0});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return read(std::uint32_t{0});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return read(std::uint16_t{0});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return read(std::uint8_t{0});
    default:
      throw std::invalid_argument("unexpected component type");
  }
}

/// Rows that fill a buffer view from its start to its end.
Eigen::MatrixXd view_rows(const tinygltf::Model& model, int view_index, Eigen::Index rows, int columns,
                          int type) {
  const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(view_index));
  const std::vector<unsigned char>& data = model.buffers.at(static_cast<std::size_t>(view.buffer)).data;
  const std::size_t row_bytes = static_cast<std::size_t>(columns) * component_bytes(type);
  const std::size_t stride = view.byteStride > 0 ? view.byteStride : row_bytes;
  const std::size_t wanted = static_cast<std::size_t>(rows) * stride;
  if (view.byteLength != wanted) throw std::out_of_range("the buffer view is not as long as its accessor");
  Eigen::MatrixXd result(rows, columns);
  for (Eigen::Index row = 0; row < rows; ++row) {
    std::size_t at = view.byteOffset + static_cast<std::size_t>(row) * stride;
    for (int column = 0; column < columns; ++column, at += component_bytes(type)) {
      result(row, column) = component(data, at, type);
    }
  }
  return result;
}

/// What stands for 1 among the integers of a type.
double largest_of(int type) {
  return std::exp2(8.0 * static_cast<double>(component_bytes(type)) - 1) - 1;
}

}  // namespace

tinygltf::Model load_glb(const std::filesystem::path& path) {
  tinygltf::TinyGLTF reader;
  const auto leave_undecoded = [](tinygltf::Image*, const int, std::string*, std::string*, int, int,
                                  const unsigned char*, int, void*) { return true; };
  reader.SetImageLoader(leave_undecoded, nullptr);
  tinygltf::Model model;
  std::string errors, warnings;
  const bool loaded = reader.LoadBinaryFromFile(&model, &errors, &warnings, path.string());
  EXPECT_TRUE(loaded) << errors;
  EXPECT_EQ(errors + warnings, "");
  return model;
}

Eigen::MatrixXd rows_of(const tinygltf::Model& model, int index) {
  const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(index));
  const auto count = static_cast<Eigen::Index>(accessor.count);
  const int columns = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  if (!accessor.sparse.isSparse) {
    const Eigen::MatrixXd rows =
        view_rows(model, accessor.bufferView, count, columns, accessor.componentType);
    return accessor.normalized ? (rows / largest_of(accessor.componentType)).cwiseMax(-1) : rows;
  }
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(count, columns);
  const auto& sparse = accessor.sparse;
  const Eigen::MatrixXd indices =
      view_rows(model, sparse.indices.bufferView, sparse.count, 1, sparse.indices.componentType);
  const Eigen::MatrixXd values =
      view_rows(model, sparse.values.bufferView, sparse.count, columns, accessor.componentType);
  for (int i = 0; i < sparse.count; ++i) {
    if (i > 0) {
      EXPECT_GT(indices(i, 0), indices(i - 1, 0)) << "sparse indices must increase";
    }
    rows.row(static_cast<Eigen::Index>(indices(i, 0))) = values.row(i);
  }
  return rows;
}

std::size_t stored_bytes(const tinygltf::Model& model, int index) {
  const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(index));
  const auto bytes = [&](int view) {
    return model.bufferViews.at(static_cast<std::size_t>(view)).byteLength;
  };
  if (!accessor.sparse.isSparse) return bytes(accessor.bufferView);
  return bytes(accessor.sparse.indices.bufferView) + bytes(accessor.sparse.values.bufferView);
}

std::vector<float> weights_at(const tinygltf::Model& model, float seconds) {
  const tinygltf::AnimationSampler& sampler = model.animations.at(0).samplers.at(0);
  EXPECT_EQ(sampler.interpolation, "LINEAR");
  const Eigen::MatrixXf times = rows_of(model, sampler.input).cast<float>();
  const Eigen::MatrixXf weights = rows_of(model, sampler.output).cast<float>();
  const Eigen::Index targets = weights.rows() / times.rows();
  Eigen::Index key = 0;
  while (key + 1 < times.rows() && times(key + 1, 0) <= seconds) ++key;
  const Eigen::Index next = std::min(key + 1, times.rows() - 1);
  const float span = times(next, 0) - times(key, 0);
  const float share = span > 0 ? std::max(0.0F, (seconds - times(key, 0)) / span) : 0.0F;
  std::vector<float> result;
  for (Eigen::Index k = 0; k < targets; ++k) {
    result.push_back((1 - share) * weights(key * targets + k, 0) + share * weights(next * targets + k, 0));
  }
  return result;
}

Eigen::MatrixXf morphed(const tinygltf::Model& model, std::size_t primitive, const std::string& attribute,
                        const std::vector<float>& weights) {
  const tinygltf::Primitive& written = model.meshes.at(0).primitives.at(primitive);
  Eigen::MatrixXf sum = rows_of(model, written.attributes.at(attribute)).cast<float>();
  for (std::size_t k = 0; k < weights.size(); ++k) {
    if (weights[k] == 0) continue;
    sum += weights[k] * rows_of(model, written.targets.at(k).at(attribute)).cast<float>();
  }
  return sum;
}

}  // namespace flexkey::testing
