#include "flexkey/gltf/write_glb.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <optional>

#include "flexkey/gltf/check_clip.h"
#include "flexkey/gltf/extras.h"
#include "flexkey/gltf/materials.h"
#include "flexkey/gltf/measure.h"
#include "flexkey/gltf/morphs.h"
#include "flexkey/gltf/primitives.h"
#include "flexkey/gltf/save_glb.h"
#include "flexkey/gltf/shape.h"
#include "flexkey/gltf/size_estimate.h"
#include "flexkey/gltf/textures.h"
#include "flexkey/gltf/utf8.h"

namespace flexkey {
namespace {

// Every target costs the client 32 bytes a vertex of GPU memory, sparse or not.
constexpr std::size_t kManyTargets = 128;

GlbContents contents_of(const Clip& clip, const std::vector<Primitive>& primitives,
                        const TextureSet& textures, const GltfOptions& options) {
  GlbContents contents = count_contents(clip, primitives);
  contents.normals = options.normals;
  for (const Texture& texture : textures.textures) {
    contents.image_bytes += static_cast<std::int64_t>(texture.bytes.size());
  }
  return contents;
}

void append_scene(tinygltf::Model& model, const Clip& clip) {
  tinygltf::Node node;
  node.name = valid_utf8(clip.name);
  node.mesh = 0;
  model.nodes.push_back(std::move(node));
  tinygltf::Scene scene;
  scene.nodes.push_back(0);
  model.scenes.push_back(std::move(scene));
  model.defaultScene = 0;
}

void describe(tinygltf::Model& model, const Clip& clip, const std::string& hash, const PlaybackError& error) {
  model.asset.version = "2.0";
  model.asset.generator = "flexkey " FLEXKEY_VERSION;
  const tinygltf::Value about = describe_clip(clip, hash, error);
  model.animations[0].extras = about;
  tinygltf::Value::Object extras = about.Get<tinygltf::Value::Object>();
  tinygltf::Value::Array names;
  for (const FrameReport& report : clip.reports) names.emplace_back(target_name(report.frame));
  extras["targetNames"] = tinygltf::Value(names);
  model.meshes[0].extras = tinygltf::Value(extras);
}

GltfReport report_on(const tinygltf::Model& model, const std::vector<Primitive>& primitives,
                     const PlaybackError& error) {
  GltfReport report;
  report.targets = static_cast<int>(model.meshes[0].weights.size());
  for (const Primitive& primitive : primitives)
    report.vertices += static_cast<int>(primitive.vertices.size());
  report.error = error.largest;
  report.kg_error = error.kg;
  report.normal_error_mean = error.normal_mean;
  report.normal_error_largest = error.normal_largest;
  return report;
}

}  // namespace

GltfReport write_glb(const Clip& clip, const GltfOptions& options, const std::filesystem::path& path) {
  check_clip(clip, options.max_targets);
  const std::vector<Primitive> primitives = split_primitives(clip.mesh);
  const TextureSet textures = read_textures(clip.mesh, primitives, options.texture_folder);
  const GlbContents contents = contents_of(clip, primitives, textures, options);
  check_glb_size(contents);
  std::optional<SeamlessNormals> normals;
  if (options.normals) normals.emplace(clip.mesh);

  tinygltf::Model model;
  model.buffers.emplace_back();
  model.buffers[0].data.reserve(static_cast<std::size_t>(estimate_glb_bytes(contents)));
  append_materials(model, clip.mesh, primitives, textures);
  append_morph_mesh(model, clip, primitives, normals);
  append_scene(model, clip);
  append_weights_animation(model, clip);
  const PlaybackError error = measure_playback(model, clip, primitives, normals);
  describe(model, clip, options.hash, error);

  GltfReport report = report_on(model, primitives, error);
  report.warnings = textures.warnings;
  if (clip.frames.size() > kManyTargets) {
    report.warnings.push_back(fmt::format(
        "{} morph targets take {:.0f} MiB of GPU memory, and many viewers are slow beyond 128",
        clip.frames.size(),
        32.0 * static_cast<double>(report.vertices) * static_cast<double>(clip.frames.size()) / (1 << 20)));
  }
  report.bytes = save_glb(model, path);
  return report;
}

}  // namespace flexkey
