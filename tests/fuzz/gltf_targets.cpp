#include "flexkey/gltf/node_motion.h"
#include "flexkey/gltf/read_gltf.h"
#include "fuzz/check_mesh.h"
#include "fuzz/targets.h"
#include "support/gltf_builder.h"

namespace flexkey::fuzz {
namespace {

constexpr const char* file = "/nowhere/x.glb";

/// The tube with an animation of its node.
std::string moving_tube() {
  meshes::GltfBuilder tube = meshes::tube_file();
  const int times = tube.add_accessor(std::vector<float>{0, 0.5, 1}, 1);
  const int moves = tube.add_accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0}, 3);
  const int turns = tube.add_accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 0}, 4);
  tube.add("animations", {{"channels",
                           {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}},
                            {{"sampler", 1}, {"target", {{"node", 0}, {"path", "rotation"}}}}}},
                          {"samplers",
                           {{{"input", times}, {"output", moves}, {"interpolation", "LINEAR"}},
                            {{"input", times}, {"output", turns}, {"interpolation", "STEP"}}}}});
  return tube.glb();
}

}  // namespace

void run_glb(std::string_view bytes) {
  try {
    const GltfFile read = parse_gltf(std::string(bytes), file);
    check_mesh(read.file.mesh);
    promise(read.source.normals.rows() == read.file.mesh.vertex_count(), "a normal a vertex");
  } catch (const Error&) {
    // Refused, as it may be.
  }
}

void run_motion(std::string_view bytes) {
  try {
    double time = -1;
    for (const NodeSample& sample : parse_node_motion(std::string(bytes), file, "tube")) {
      promise(sample.time > time, "times that increase");
      promise(
          sample.translation.allFinite() && sample.rotation.coeffs().allFinite() && sample.scale.allFinite(),
          "finite motions");
      time = sample.time;
    }
  } catch (const Error&) {
    // Refused, as it may be.
  }
}

std::vector<std::string> glb_seeds() {
  return {meshes::tube_file().glb(), meshes::tube_with_targets().glb(), meshes::two_tubes().glb(),
          meshes::skinned_tube().glb()};
}

std::vector<std::string> motion_seeds() {
  return {moving_tube()};
}

}  // namespace flexkey::fuzz
