#include "flexkey/gltf/handle_nodes.h"

#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <set>
#include <string>

#include "flexkey/gltf/accessors.h"
#include "flexkey/gltf/gltf_scene.h"
#include "flexkey/gltf/unique_name.h"
#include "flexkey/gltf/utf8.h"

namespace flexkey {
namespace {

/// A handle's node over some frames, #frames rows each.
struct NodeMotion {
  Vec3 pivot;              // where it rests
  FloatRows translations;  // x 3
  FloatRows rotations;     // x 4, unit quaternions x y z w
  FloatRows scales;        // x 3
};

/// Rotation times scale along the axes that it turns, as a handle moves; a reflection goes into the first
/// axis.
void decompose(const Eigen::Matrix3d& linear, Eigen::Quaterniond& rotation, Vec3& scale) {
  scale = linear.colwise().norm().transpose();
  if (linear.determinant() < 0) scale.x() = -scale.x();
  Eigen::Matrix3d axes;
  for (int i = 0; i < 3; ++i) axes.col(i) = linear.col(i) / scale[i];
  if (axes.allFinite()) rotation = Eigen::Quaterniond(axes).normalized();  // else as it was before
}

NodeMotion motion_of(const HandleTrack& handle, const std::vector<std::size_t>& frames) {
  const auto count = static_cast<Eigen::Index>(frames.size());
  NodeMotion motion{handle.pivot, FloatRows(count, 3), FloatRows(count, 4), FloatRows(count, 3)};
  Eigen::Quaterniond before = Eigen::Quaterniond::Identity();
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Affine3d matrix(handle.matrices[frames[static_cast<std::size_t>(k)]]);
    Eigen::Quaterniond rotation = before;
    Vec3 scale;
    decompose(matrix.linear(), rotation, scale);
    if (rotation.dot(before) < 0) rotation.coeffs() = -rotation.coeffs();  // the short way round
    before = rotation;
    motion.translations.row(k) = (matrix * handle.pivot).cast<float>().transpose();
    motion.rotations.row(k) = rotation.coeffs().cast<float>().transpose();
    motion.scales.row(k) = scale.cast<float>().transpose();
  }
  return motion;
}

/// Frames of the clip, and when they are played.
struct PlayedFrames {
  std::vector<std::size_t> frames;
  std::vector<double> seconds;  // of the shot
};

/// A clip that comes round ends with its first frame.
PlayedFrames frames_within(const Clip& clip, const PlayedRange& range) {
  constexpr double rounding = 1e-9;
  PlayedFrames played;
  const auto add = [&](std::size_t k, double second) {
    if (second < range.from - rounding || second > range.to + rounding) return;
    played.frames.push_back(k);
    played.seconds.push_back(second);
  };
  for (std::size_t k = 0; k < clip.reports.size(); ++k) add(k, clip.reports[k].frame / clip.fps);
  if (comes_round(clip)) add(0, clip.period / clip.fps);
  return played;
}

/// Seconds from the range's start, #frames x 1.
FloatRows times_of(const PlayedFrames& played, double from) {
  FloatRows times(static_cast<Eigen::Index>(played.seconds.size()), 1);
  for (std::size_t k = 0; k < played.seconds.size(); ++k)
    times(static_cast<Eigen::Index>(k), 0) = static_cast<float>(std::max(played.seconds[k] - from, 0.0));
  return times;
}

/// Values of one of a node's channels, a row a frame.
struct Path {
  std::string name;
  FloatRows rows;
};

/// What of a motion is ever away from rest.
std::vector<Path> moving_paths(const NodeMotion& motion) {
  std::vector<Path> paths;
  const auto add = [&](const char* name, const FloatRows& rows, const Eigen::RowVectorXf& rest) {
    if (rows != rest.replicate(rows.rows(), 1)) paths.push_back({name, rows});
  };
  add("translation", motion.translations, motion.pivot.cast<float>().transpose());
  add("rotation", motion.rotations, Eigen::RowVector4f(0, 0, 0, 1));
  add("scale", motion.scales, Eigen::RowVector3f::Ones());
  return paths;
}

/// A node a handle, of a name that no other node has: what reads the motion back finds it by that.
std::vector<NewNode> nodes_of(const GltfScene& scene, const std::vector<HandleTrack>& handles) {
  std::set<std::string> known;
  for (const GltfNode& node : scene.nodes) known.insert(node.name);
  std::vector<NewNode> nodes;
  for (const HandleTrack& handle : handles)
    nodes.push_back({unique_name(valid_utf8(handle.name), known), handle.pivot});
  return nodes;
}

}  // namespace

Addition add_handles(const Glb& file, const Clip& clip, const std::vector<HandleTrack>& handles,
                     const std::vector<PlayedRange>& ranges) {
  const GltfScene scene = parse_gltf_scene(file.json);
  const int first_node = static_cast<int>(scene.nodes.size());
  tinygltf::Model model;
  model.buffers.emplace_back();
  Addition addition;
  addition.new_nodes = nodes_of(scene, handles);
  for (const PlayedRange& range : ranges) {
    const PlayedFrames played = frames_within(clip, range);
    if (played.frames.empty()) continue;
    AnimationAddition animation{"", range.animation, {}};
    int input = -1;  // none where no handle moves
    for (std::size_t h = 0; h < handles.size(); ++h)
      for (const Path& path : moving_paths(motion_of(handles[h], played.frames))) {
        if (input < 0) input = append_times(model, times_of(played, range.from));
        const int node = first_node + static_cast<int>(h);
        animation.channels.push_back({node, input, append_values(model, path.rows), path.name});
      }
    addition.animations.push_back(std::move(animation));
  }
  addition.glb = glb_of(std::move(model));
  return addition;
}

}  // namespace flexkey
