#include "flexkey/gltf/node_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "flexkey/gltf/gather_buffers.h"
#include "flexkey/gltf/gltf_scene.h"
#include "flexkey/gltf/node_tree.h"
#include "flexkey/gltf/read_accessor.h"
#include "flexkey/gltf/sampler_track.h"
#include "flexkey/gltf/split_container.h"
#include "flexkey/mesh/read_file.h"
#include "flexkey/mesh/spelling.h"

namespace flexkey {
namespace {

constexpr double between = 1.0 / 60;  // seconds, the longest time without a sample
constexpr std::size_t most_samples = 1'000'000;

/// The channels of one node.
struct NodeTracks {
  std::map<std::string, SamplerTrack> by_path;
};

/// A node's place in its parent's space.
struct Placement {
  Eigen::Vector3d translation;
  Eigen::Quaterniond rotation;
  Eigen::Vector3d scale;

  Eigen::Affine3d matrix() const {
    return Eigen::Translation3d(translation) * rotation * Eigen::Scaling(scale);
  }
};

Placement placement_of(const Eigen::Matrix4d& matrix) {
  const Eigen::Affine3d affine(matrix);
  Eigen::Matrix3d rotation, stretch;
  affine.computeRotationScaling(&rotation, &stretch);
  return {affine.translation(), Eigen::Quaterniond(rotation), stretch.diagonal()};
}

Eigen::Quaterniond quaternion(const Eigen::RowVectorXf& xyzw) {
  return Eigen::Quaterniond(xyzw[3], xyzw[0], xyzw[1], xyzw[2]).normalized();
}

/// LINEAR turns go along great arcs; Eigen's slerp takes the shorter one, as glTF wants.
Eigen::Quaterniond rotation_at(const SamplerTrack& track, float time) {
  if (track.interpolation != "LINEAR") return quaternion(sample(track, time));
  const float *first = track.times.data(), *end = first + track.times.rows();
  const float* after = std::upper_bound(first, end, time);
  if (after == first || after == end) return quaternion(sample(track, time));
  const float share = (time - after[-1]) / (after[0] - after[-1]);
  return quaternion(sample(track, after[-1])).slerp(share, quaternion(sample(track, after[0])));
}

Placement placed(const GltfNode& node, const NodeTracks& tracks, float time) {
  Placement placement = placement_of(node.local);
  for (const auto& [path, track] : tracks.by_path) {
    if (path == "rotation") {
      placement.rotation = rotation_at(track, time);
    } else {
      (path == "scale" ? placement.scale : placement.translation) =
          sample(track, time).transpose().cast<double>();
    }
  }
  return placement;
}

/// The node and those above it, it first.
std::vector<int> chain_of(const GltfScene& scene, int node) {
  std::vector<int> parents(scene.nodes.size(), -1);
  for (std::size_t n = 0; n < scene.nodes.size(); ++n)
    for (const int child : scene.nodes[n].children)
      parents[static_cast<std::size_t>(child)] = static_cast<int>(n);
  std::vector<int> chain;
  for (int at = node; at >= 0; at = parents[static_cast<std::size_t>(at)]) chain.push_back(at);
  return chain;
}

int node_of(const GltfScene& scene, const std::string& name, const std::string& file) {
  std::vector<std::string> known;
  for (int n = 0; n < static_cast<int>(scene.nodes.size()); ++n) {
    if (node_name(scene, n) == name) return n;
    known.push_back(node_name(scene, n));
  }
  throw InputError(no_such_name("node", name, file, known));
}

SamplerTrack track_of(const GltfSampler& sampler, int columns, const AccessorReader& reader) {
  SamplerTrack track;
  track.interpolation = sampler.interpolation;
  track.times = reader.rows(sampler.input, 1).cast<float>();
  track.values = reader.rows(sampler.output, columns).cast<float>();
  const Eigen::Index values = track.times.rows() * (sampler.interpolation == "CUBICSPLINE" ? 3 : 1);
  if (track.times.rows() == 0 || track.values.rows() != values)
    throw InputError("an animation's sampler has not as many values as times");
  for (Eigen::Index k = 0; k < track.times.rows(); ++k)
    if (track.times(k, 0) < 0 || (k > 0 && track.times(k, 0) <= track.times(k - 1, 0)))
      throw InputError("an animation's times do not increase from 0");
  return track;
}

/// The tracks of a chain's nodes in the first animation that has any; none where there is no such animation.
std::map<int, NodeTracks> tracks_of(const GltfScene& scene, const std::vector<int>& chain,
                                    const AccessorReader& reader) {
  std::map<int, NodeTracks> tracks;
  for (const GltfAnimation& animation : scene.animations) {
    for (const GltfNodeChannel& channel : animation.nodes) {
      if (std::find(chain.begin(), chain.end(), channel.node) == chain.end()) continue;
      const GltfSampler& sampler = animation.samplers[static_cast<std::size_t>(channel.sampler)];
      tracks[channel.node].by_path[channel.path] =
          track_of(sampler, channel.path == "rotation" ? 4 : 3, reader);
    }
    if (!tracks.empty()) break;
  }
  return tracks;
}

/// Every key's time, and times between.
std::vector<float> times_of(const std::map<int, NodeTracks>& tracks) {
  std::set<float> keys;
  for (const auto& [node, own] : tracks)
    for (const auto& [path, track] : own.by_path) {
      keys.insert(track.times.data(), track.times.data() + track.times.rows());
      if (track.interpolation == "STEP")
        for (Eigen::Index k = 1; k < track.times.rows(); ++k)
          keys.insert(std::nextafter(track.times(k, 0), 0.0F));
    }
  const double span = *keys.rbegin() - *keys.begin();
  if (span / between + static_cast<double>(keys.size()) > static_cast<double>(most_samples))
    throw InputError(fmt::format("the animation is {:.0f} s long, too long to follow", span));
  std::vector<float> times;
  for (const float key : keys) {
    const float last = times.empty() ? key : times.back();
    const int parts = static_cast<int>(std::ceil((key - last) / between - 1e-3));
    for (int part = 1; part < parts; ++part)
      times.push_back(last + (key - last) * static_cast<float>(part) / static_cast<float>(parts));
    times.push_back(key);
  }
  return times;
}

std::vector<NodeSample> parse(const std::string& file, const std::filesystem::path& path,
                              const std::string& name) {
  const Gathered gathered = gather_buffers(split_container(file), path.parent_path());
  const GltfScene scene = parse_gltf_scene(gathered.document.json);
  const NodeTree tree(scene);  // for its checks: no node is above itself
  const std::vector<int> chain = chain_of(scene, node_of(scene, name, path.filename().string()));
  const AccessorReader reader(scene, gathered.document.bytes);
  const std::map<int, NodeTracks> tracks = tracks_of(scene, chain, reader);
  if (tracks.empty()) throw InputError(fmt::format("no animation moves node '{}'", name));
  std::vector<NodeSample> samples;
  for (const float time : times_of(tracks)) {
    Eigen::Affine3d world = Eigen::Affine3d::Identity();
    for (const int node : chain) {
      const auto found = tracks.find(node);
      world = placed(scene.nodes[static_cast<std::size_t>(node)],
                     found == tracks.end() ? NodeTracks{} : found->second, time)
                  .matrix() *
              world;
    }
    const Placement whole = placement_of(world.matrix());
    samples.push_back({time, whole.translation, whole.rotation, whole.scale});
  }
  return samples;
}

}  // namespace

std::vector<NodeSample> read_node_motion(const std::filesystem::path& path, const std::string& node) {
  return parse_node_motion(read_file(path), path, node);
}

std::vector<NodeSample> parse_node_motion(const std::string& file, const std::filesystem::path& path,
                                          const std::string& node) {
  try {
    return parse(file, path, node);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

}  // namespace flexkey
