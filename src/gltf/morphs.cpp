#include "flexkey/gltf/morphs.h"

#include <tiny_gltf.h>

#include <map>
#include <string>

#include "flexkey/gltf/accessors.h"
#include "flexkey/gltf/extras.h"
#include "flexkey/gltf/utf8.h"

namespace flexkey {
namespace {

tinygltf::Primitive base_primitive(tinygltf::Model& model, const Mesh& mesh, const Primitive& primitive,
                                   const Shape& rest) {
  tinygltf::Primitive base;
  base.mode = TINYGLTF_MODE_TRIANGLES;
  base.attributes["POSITION"] = append_attribute(model, gather(rest.positions, primitive));
  if (rest.normals.rows() > 0) {
    base.attributes["NORMAL"] = append_attribute(model, gather(rest.normals, primitive));
  }
  if (!primitive.texcoords.empty()) {
    base.attributes["TEXCOORD_0"] = append_attribute(model, texcoords_of(mesh, primitive));
  }
  base.indices = append_triangles(model, primitive.triangles);
  base.extras = describe_groups(mesh, primitive);
  return base;
}

/// The motion from rest to pose is the difference of what both round to, so that base + delta in floats is
/// the float nearest to the pose, and a vertex at rest gives exact zeros though its rest position may be no
/// float.
int append_motion(tinygltf::Model& model, const FloatRows& pose, const FloatRows& rest,
                  const Primitive& primitive) {
  return append_deltas(model, nonzero_rows(gather(pose - rest, primitive)));
}

std::map<std::string, int> append_target(tinygltf::Model& model, const Shape& pose, const Shape& rest,
                                         const Primitive& primitive) {
  std::map<std::string, int> target;
  target["POSITION"] = append_motion(model, pose.positions, rest.positions, primitive);
  if (rest.normals.rows() > 0) {
    target["NORMAL"] = append_motion(model, pose.normals, rest.normals, primitive);
  }
  return target;
}

/// #frames x 1, seconds; a clip of some frames of its shot begins at its first.
FloatRows key_times(const Clip& clip) {
  FloatRows times(static_cast<Eigen::Index>(clip.frames.size()), 1);
  for (std::size_t k = 0; k < clip.frames.size(); ++k) {
    const int since_first = clip.reports[k].frame - clip.reports[0].frame;
    times(static_cast<Eigen::Index>(k), 0) = static_cast<float>(since_first / clip.fps);
  }
  return times;
}

/// The identity, row after row: #frames² x 1.
SparseRows key_weights(std::int64_t frames) {
  SparseRows weights{frames * frames, {}, FloatRows::Ones(frames, 1)};
  for (std::int64_t k = 0; k < frames; ++k) {
    weights.indices.push_back(static_cast<std::uint32_t>(k * (frames + 1)));
  }
  return weights;
}

}  // namespace

void append_morph_mesh(tinygltf::Model& model, const Clip& clip, const std::vector<Primitive>& primitives,
                       const std::optional<SeamlessNormals>& normals) {
  const Shape rest = shape_at(clip.mesh.positions, normals);
  tinygltf::Mesh mesh;
  mesh.name = valid_utf8(clip.name);
  mesh.weights.assign(clip.frames.size(), 0.0);
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    mesh.primitives.push_back(base_primitive(model, clip.mesh, primitives[i], rest));
    mesh.primitives.back().material = static_cast<int>(i);
  }
  for (const Positions& frame : clip.frames) {
    const Shape pose = shape_at(frame, normals);
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      mesh.primitives[i].targets.push_back(append_target(model, pose, rest, primitives[i]));
    }
  }
  model.meshes.push_back(std::move(mesh));
}

void append_weights_animation(tinygltf::Model& model, const Clip& clip) {
  tinygltf::AnimationSampler sampler;
  sampler.interpolation = "LINEAR";
  sampler.input = append_times(model, key_times(clip));
  sampler.output = append_samples(model, key_weights(static_cast<std::int64_t>(clip.frames.size())));
  tinygltf::AnimationChannel channel;
  channel.sampler = 0;
  channel.target_node = 0;
  channel.target_path = "weights";

  tinygltf::Animation animation;
  animation.name = valid_utf8(clip.name);
  animation.samplers.push_back(std::move(sampler));
  animation.channels.push_back(std::move(channel));
  model.animations.push_back(std::move(animation));
}

}  // namespace flexkey
