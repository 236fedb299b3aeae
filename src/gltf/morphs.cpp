#include "flexkey/gltf/morphs.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "flexkey/gltf/accessors.h"
#include "flexkey/gltf/extras.h"
#include "flexkey/gltf/float_grid.h"
#include "flexkey/gltf/split_note.h"
#include "flexkey/gltf/utf8.h"

namespace flexkey {
namespace {

tinygltf::Primitive base_primitive(tinygltf::Model& model, const Asset& asset, const Primitive& primitive) {
  tinygltf::Primitive base;
  base.mode = TINYGLTF_MODE_TRIANGLES;
  base.attributes["POSITION"] = append_attribute(model, gather(asset.rest.positions, primitive));
  if (asset.rest.normals.rows() > 0) {
    base.attributes["NORMAL"] = append_attribute(model, gather(asset.rest.normals, primitive));
  }
  if (!primitive.texcoords.empty()) {
    const FloatRows texcoords = texcoords_of(asset.clip.mesh, primitive);
    const double step = asset.texcoord_step;
    base.attributes["TEXCOORD_0"] = append_attribute(model, step > 0 ? on_grid(texcoords, step) : texcoords);
  }
  base.indices = append_triangles(model, primitive.triangles);
  base.extras = describe_groups(asset.clip.mesh, primitive);
  return base;
}

/// The model's material, which it has one of for each of the asset's primitives.
int material_of(const Asset& asset, const Primitive& primitive) {
  const auto found = std::find_if(asset.primitives.begin(), asset.primitives.end(),
                                  [&](const Primitive& one) { return one.material == primitive.material; });
  return static_cast<int>(found - asset.primitives.begin());
}

/// The mesh without targets, in its primitives' order.
tinygltf::Mesh base_mesh(tinygltf::Model& model, const Asset& asset,
                         const std::vector<Primitive>& primitives) {
  tinygltf::Mesh mesh;
  mesh.name = valid_utf8(asset.clip.name);
  for (const Primitive& primitive : primitives) {
    mesh.primitives.push_back(base_primitive(model, asset, primitive));
    mesh.primitives.back().material = material_of(asset, primitive);
  }
  return mesh;
}

int append_gathered(tinygltf::Model& model, const FloatRows& deltas, const Primitive& primitive) {
  return append_deltas(model, nonzero_rows(gather(deltas, primitive)));
}

/// The accessor of a primitive's targets that move nothing, by the largest integer of their type: one serves
/// them all.
using Zeros = std::map<int, int>;

int append_integers(tinygltf::Model& model, const ShortRows& rows, int largest, Zeros& zeros) {
  if (!rows.isZero(0)) return append_normalized(model, rows, largest);
  const auto found = zeros.find(largest);
  if (found != zeros.end()) return found->second;
  return zeros[largest] = append_normalized(model, rows, largest);
}

/// Row after row, without the zeros.
SparseRows sparse_samples(const Eigen::MatrixXf& weights) {
  const FloatRows rows = weights;
  return nonzero_rows(rows.reshaped<Eigen::RowMajor>());
}

}  // namespace

void append_morph_mesh(tinygltf::Model& model, const Asset& asset, const std::vector<Primitive>& moving,
                       MorphTargets targets) {
  tinygltf::Mesh mesh = base_mesh(model, asset, moving);
  mesh.weights.assign(targets.positions.size(), 0.0);
  for (std::size_t t = 0; t < targets.positions.size(); ++t) {
    const FloatRows positions = std::move(targets.positions[t]);
    const FloatRows normals = targets.normals.empty() ? FloatRows() : std::move(targets.normals[t]);
    for (std::size_t i = 0; i < moving.size(); ++i) {
      std::map<std::string, int> target;
      target["POSITION"] = append_gathered(model, positions, moving[i]);
      if (normals.rows() > 0) target["NORMAL"] = append_gathered(model, normals, moving[i]);
      mesh.primitives[i].targets.push_back(std::move(target));
    }
  }
  model.meshes.push_back(std::move(mesh));
}

void append_morph_mesh(tinygltf::Model& model, const Asset& asset, const std::vector<Primitive>& moving,
                       const QuantizedTargets& targets) {
  for (auto* list : {&model.extensionsUsed, &model.extensionsRequired})
    list->emplace_back("KHR_mesh_quantization");
  tinygltf::Mesh mesh = base_mesh(model, asset, moving);
  mesh.weights.assign(targets.positions.size() + targets.poses.positions.size(), 0.0);
  for (std::size_t i = 0; i < moving.size(); ++i) {
    const std::vector<int>& vertices = moving[i].vertices;
    Zeros zeros;
    for (std::size_t t = 0; t < targets.positions.size(); ++t) {
      std::map<std::string, int> target;
      target["POSITION"] = append_integers(model, targets.positions[t](vertices, Eigen::all), 32767, zeros);
      if (!targets.normals.empty()) {
        target["NORMAL"] =
            append_integers(model, targets.normals[t](vertices, Eigen::all), targets.normal_largest, zeros);
      } else if (!targets.float_normals.empty()) {
        target["NORMAL"] = append_attribute(model, gather(targets.float_normals[t], moving[i]));
      }
      mesh.primitives[i].targets.push_back(std::move(target));
    }
    for (std::size_t p = 0; p < targets.poses.positions.size(); ++p) {
      std::map<std::string, int> target;
      target["POSITION"] = append_attribute(model, gather(targets.poses.positions[p], moving[i]));
      if (!targets.poses.normals.empty())
        target["NORMAL"] = append_attribute(model, gather(targets.poses.normals[p], moving[i]));
      mesh.primitives[i].targets.push_back(std::move(target));
    }
  }
  model.meshes.push_back(std::move(mesh));
}

void append_still_mesh(tinygltf::Model& model, const Asset& asset, const std::vector<Primitive>& still) {
  tinygltf::Mesh mesh = base_mesh(model, asset, still);
  mesh.name = still_name(mesh.name);
  model.meshes.push_back(std::move(mesh));
}

void append_weights_animation(tinygltf::Model& model, const WeightTrack& track) {
  FloatRows times(static_cast<Eigen::Index>(track.times.size()), 1);
  for (std::size_t k = 0; k < track.times.size(); ++k) {
    times(static_cast<Eigen::Index>(k), 0) = static_cast<float>(track.times[k]);
  }
  tinygltf::AnimationSampler sampler;
  sampler.interpolation = "LINEAR";
  sampler.input = append_times(model, times);
  sampler.output = append_samples(model, sparse_samples(track.weights));
  tinygltf::AnimationChannel channel;
  channel.sampler = 0;
  channel.target_node = 0;
  channel.target_path = "weights";

  tinygltf::Animation animation;
  animation.name = valid_utf8(track.name);
  animation.samplers.push_back(std::move(sampler));
  animation.channels.push_back(std::move(channel));
  model.animations.push_back(std::move(animation));
}

}  // namespace flexkey
