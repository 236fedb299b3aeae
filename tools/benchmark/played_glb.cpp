#include "played_glb.h"

#include <algorithm>
#include <vector>

#include "flexkey/gltf/gltf_scene.h"
#include "flexkey/gltf/node_tree.h"
#include "flexkey/gltf/read_accessor.h"
#include "flexkey/gltf/read_gltf.h"
#include "flexkey/gltf/sampler_track.h"
#include "flexkey/mesh/error.h"

namespace flexkey::bench {
namespace {

/// A primitive with what plays its targets.
struct Played {
  FloatRows base;                  // #V x 3
  std::vector<FloatRows> targets;  // of #V x 3
  SamplerTrack weights;
  Eigen::Matrix4d world;

  Positions at(float seconds) const {
    const Eigen::RowVectorXf now = sample(weights, seconds);
    FloatRows sum = base;
    for (std::size_t t = 0; t < targets.size(); ++t)
      if (const float weight = now[static_cast<Eigen::Index>(t)]; weight != 0) sum += weight * targets[t];
    const Eigen::Matrix3d linear = world.topLeftCorner<3, 3>();
    return (sum.cast<double>() * linear.transpose()).rowwise() + world.topRightCorner<3, 1>().transpose();
  }
};

SamplerTrack track_of(const AccessorReader& reader, const GltfSampler& sampler) {
  SamplerTrack track;
  track.interpolation = sampler.interpolation;
  track.times = reader.rows(sampler.input, 1).cast<float>();
  const FloatRows values = reader.rows(sampler.output, 1).cast<float>();
  track.values = values.reshaped<Eigen::RowMajor>(track.times.rows(), values.rows() / track.times.rows());
  return track;
}

std::vector<Played> primitives_of(const std::filesystem::path& glb) {
  const GltfFile file = read_gltf(glb);
  const GltfScene scene = parse_gltf_scene(file.source.document.json);
  const AccessorReader reader(scene, file.source.document.bytes);
  const NodeTree tree(scene);
  std::vector<Played> all;
  for (const GltfAnimation& animation : scene.animations)
    for (const GltfWeightsChannel& channel : animation.weights) {
      const GltfNode& node = scene.nodes[static_cast<std::size_t>(channel.node)];
      for (const GltfPrimitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
        Played played;
        played.base = reader.rows(primitive.attributes.at("POSITION"), 3).cast<float>();
        for (const GltfAttributes& target : primitive.targets)
          played.targets.push_back(reader.rows(target.at("POSITION"), 3).cast<float>());
        played.weights = track_of(reader, animation.samplers[static_cast<std::size_t>(channel.sampler)]);
        played.world = tree.world(channel.node);
        all.push_back(std::move(played));
      }
    }
  if (all.empty()) throw Error("bench: a file has no animation of weights");
  return all;
}

/// The nearest of the points to each row.
std::vector<int> nearest(const Positions& rows, const Positions& points) {
  std::vector<int> found;
  for (const auto& row : rows.rowwise()) {
    Eigen::Index best = 0;
    (points.rowwise() - row).rowwise().squaredNorm().minCoeff(&best);
    found.push_back(static_cast<int>(best));
  }
  return found;
}

}  // namespace

double error_of(const std::filesystem::path& glb, const Clip& clip) {
  double largest = 0;
  for (const Played& played : primitives_of(glb)) {
    Played still = played;
    still.targets.clear();
    const std::vector<int> vertices = nearest(still.at(0), clip.mesh.positions);
    for (std::size_t k = 0; k < clip.frames.size(); ++k) {
      const double seconds = (clip.reports[k].frame - clip.reports.front().frame) / clip.fps;
      const Positions off = played.at(static_cast<float>(seconds)) - clip.frames[k](vertices, Eigen::all);
      largest = std::max(largest, off.rowwise().norm().maxCoeff());
    }
  }
  return largest / bounds_of(clip.mesh.positions).diagonal();
}

}  // namespace flexkey::bench
