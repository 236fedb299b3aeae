#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flexkey/mesh/mesh.h"

namespace flexkey {

// The part of a glTF file's JSON that flexkey reads, as plain values; indices are those of the file and -1
// stands for none.

struct GltfView {
  std::size_t offset = 0, length = 0;  // bytes of buffer 0
  std::size_t stride = 0;              // bytes from one element to the next; 0: side by side
};

/// Elements that replace those of an accessor.
struct GltfSparse {
  std::size_t count = 0;
  int index_view = -1, value_view = -1;
  std::size_t index_offset = 0, value_offset = 0;
  int index_type = 0;  // component type
};

struct GltfAccessor {
  int view = -1;  // -1: all zeros
  std::size_t offset = 0, count = 0;
  int component_type = 0;  // as OpenGL numbers them: 5120 signed byte .. 5126 float
  int columns = 0;         // 1 SCALAR .. 4 VEC4; 0 for matrices
  bool normalized = false;
  std::optional<GltfSparse> sparse;
};

using GltfAttributes = std::map<std::string, int>;  // accessor of each, by semantic ("POSITION")

/// A named part of a primitive, as flexkey itself writes it into extras.
struct GltfGroup {
  std::string name;
  std::vector<int> triangles;  // [first, count, first, count, …]
};

struct GltfPrimitive {
  int mode = 4;  // as OpenGL numbers them: 0 points .. 4 triangles, 5 strip, 6 fan
  int indices = -1, material = -1;
  GltfAttributes attributes;
  std::vector<GltfAttributes> targets;
  std::vector<GltfGroup> groups;
  std::vector<std::string> extensions;  // names
};

struct GltfMesh {
  std::string name;
  std::vector<GltfPrimitive> primitives;
  std::vector<double> weights;  // of the file's own targets
};

struct GltfNode {
  std::string name;
  int mesh = -1, skin = -1;
  std::vector<int> children;
  Eigen::Matrix4d local = Eigen::Matrix4d::Identity();
  std::vector<double> weights;          // instead of the mesh's; empty: those
  std::vector<std::string> extensions;  // names
};

struct GltfSampler {
  int input = -1, output = -1;
  std::string interpolation;  // "LINEAR", "STEP" or "CUBICSPLINE"
};

/// A channel that leads the weights of a node's mesh.
struct GltfWeightsChannel {
  int channel = 0, sampler = 0, node = 0;
};

/// A channel that leads a node itself.
struct GltfNodeChannel {
  int sampler = 0, node = 0;
  std::string path;  // "translation", "rotation" or "scale"
};

struct GltfAnimation {
  std::string name;
  std::vector<GltfSampler> samplers;
  std::vector<GltfWeightsChannel> weights;
  std::vector<GltfNodeChannel> nodes;
};

struct GltfScene {
  std::vector<GltfView> views;
  std::vector<GltfAccessor> accessors;
  std::vector<GltfMesh> meshes;
  std::vector<GltfNode> nodes;
  std::vector<Material> materials;
  std::vector<GltfAnimation> animations;
  std::vector<std::vector<int>> scenes;  // root nodes of each
  int scene = -1;                        // the default one
  std::vector<std::string> required;     // extensions without which the file cannot be read
};

/// Reads a gathered document's JSON. Throws InputError that names the thing for an index out of range, and
/// for a member that is missing or of another type.
GltfScene parse_gltf_scene(const std::string& json);

}  // namespace flexkey
