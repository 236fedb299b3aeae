#include "gltf/shown.h"

#include <algorithm>
#include <numeric>

#include "flexkey/gltf/node_tree.h"
#include "flexkey/gltf/primitive_faces.h"
#include "flexkey/gltf/read_accessor.h"
#include "flexkey/gltf/sampler_track.h"

namespace flexkey::testing {
namespace {

FloatRows morphed(const AccessorReader& reader, const GltfPrimitive& primitive, const std::string& attribute,
                  const Eigen::RowVectorXf& weights) {
  FloatRows sum = reader.rows(primitive.attributes.at(attribute), 3).cast<float>();
  for (std::size_t t = 0; t < primitive.targets.size() && weights.size() > 0; ++t)
    sum += weights[static_cast<Eigen::Index>(t)] *
           reader.rows(primitive.targets[t].at(attribute), 3).cast<float>();
  return sum;
}

FloatRows placed(const FloatRows& rows, const Eigen::Matrix4d& world) {
  const Positions positions = rows.cast<double>();
  return ((positions * world.topLeftCorner<3, 3>().transpose()).rowwise() +
          world.topRightCorner<3, 1>().transpose())
      .cast<float>();
}

/// Begins with the lowest corner: encoders turn triangles about.
std::array<int, 3> turned(std::array<int, 3> triangle, const FloatRows& rest) {
  const auto lower = [&](int a, int b) {
    return std::lexicographical_compare(rest.row(a).begin(), rest.row(a).end(), rest.row(b).begin(),
                                        rest.row(b).end());
  };
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end(), lower), triangle.end());
  return triangle;
}

}  // namespace

ShownFile::ShownFile(const std::filesystem::path& path)
    : file_(read_gltf(path)), scene_(parse_gltf_scene(file_.source.document.json)) {}

Eigen::RowVectorXf ShownFile::weights_of(int node, float seconds) const {
  const AccessorReader reader(scene_, file_.source.document.bytes);
  const GltfAnimation& animation = scene_.animations.at(0);
  for (const GltfWeightsChannel& channel : animation.weights) {
    if (channel.node != node) continue;
    const GltfSampler& sampler = animation.samplers.at(static_cast<std::size_t>(channel.sampler));
    const FloatRows times = reader.rows(sampler.input, 1).cast<float>();
    const FloatRows values = reader.rows(sampler.output, 1).cast<float>();
    const FloatRows rows = values.reshaped<Eigen::RowMajor>(times.rows(), values.rows() / times.rows());
    return sample({sampler.interpolation, times, rows}, seconds);
  }
  return {};
}

std::vector<ShownPrimitive> ShownFile::at(float seconds) const {
  const AccessorReader reader(scene_, file_.source.document.bytes);
  const NodeTree tree(scene_);
  std::vector<ShownPrimitive> all;
  for (std::size_t n = 0; n < scene_.nodes.size(); ++n) {
    if (scene_.nodes[n].mesh < 0) continue;
    const int node = static_cast<int>(n);
    const Eigen::RowVectorXf weights = weights_of(node, seconds);
    const bool is_skinned = scene_.nodes[n].skin >= 0;
    const Eigen::Matrix4d world = is_skinned ? Eigen::Matrix4d::Identity() : tree.world(node);
    for (const GltfPrimitive& primitive :
         scene_.meshes.at(static_cast<std::size_t>(scene_.nodes[n].mesh)).primitives) {
      ShownPrimitive shown;
      shown.node = node;
      shown.has_targets = !primitive.targets.empty();
      shown.rest = morphed(reader, primitive, "POSITION", {});
      shown.positions = morphed(reader, primitive, "POSITION", weights);
      for (FloatRows* rows : {&shown.rest, &shown.positions}) *rows = placed(*rows, world);
      if (primitive.attributes.contains("NORMAL")) {
        shown.rest_normals = morphed(reader, primitive, "NORMAL", {});
        shown.normals = morphed(reader, primitive, "NORMAL", weights);
      }
      std::vector<int> corners(static_cast<std::size_t>(shown.rest.rows()));
      std::iota(corners.begin(), corners.end(), 0);
      if (primitive.indices >= 0) corners = reader.indices(primitive.indices, corners.size());
      shown.triangles = triangles_of_mode(corners, primitive.mode);
      all.push_back(std::move(shown));
    }
  }
  return all;
}

std::vector<std::pair<std::array<float, 9>, std::array<float, 9>>> triangles_of(
    const std::vector<ShownPrimitive>& shown) {
  std::vector<std::pair<std::array<float, 9>, std::array<float, 9>>> all;
  for (const ShownPrimitive& primitive : shown)
    for (const std::array<int, 3>& corners : primitive.triangles) {
      const std::array<int, 3> triangle = turned(corners, primitive.rest);
      auto& [rest, posed] = all.emplace_back();
      for (std::size_t i = 0; i < 9; ++i) {
        const int row = triangle[i / 3];
        rest[i] = primitive.rest(row, static_cast<Eigen::Index>(i % 3));
        posed[i] = primitive.positions(row, static_cast<Eigen::Index>(i % 3));
      }
    }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace flexkey::testing
