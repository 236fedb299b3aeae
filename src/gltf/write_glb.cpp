#include "flexkey/gltf/write_glb.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <optional>
#include <utility>

#include "flexkey/gltf/asset.h"
#include "flexkey/gltf/built.h"
#include "flexkey/gltf/check_clip.h"
#include "flexkey/gltf/extras.h"
#include "flexkey/gltf/glb.h"
#include "flexkey/gltf/graft.h"
#include "flexkey/gltf/handle_nodes.h"
#include "flexkey/gltf/materials.h"
#include "flexkey/gltf/measure.h"
#include "flexkey/gltf/meshopt.h"
#include "flexkey/gltf/morphs.h"
#include "flexkey/gltf/moved_vertices.h"
#include "flexkey/gltf/pose_targets.h"
#include "flexkey/gltf/reduction.h"
#include "flexkey/gltf/size_estimate.h"
#include "flexkey/gltf/source_glb.h"
#include "flexkey/gltf/split_asset.h"
#include "flexkey/gltf/steps.h"
#include "flexkey/gltf/weight_tracks.h"

namespace flexkey {
namespace {

constexpr int kManyTargets = 128;
constexpr std::uintmax_t kGpuBytes = 32;  // of a target's position and normal in a client's texture

/// A node a mesh: what never moves hangs on what does, so that both go where one of them is put.
void append_scene(tinygltf::Model& model) {
  for (std::size_t mesh = 0; mesh < model.meshes.size(); ++mesh) {
    tinygltf::Node node;
    node.name = model.meshes[mesh].name;
    node.mesh = static_cast<int>(mesh);
    model.nodes.push_back(std::move(node));
    if (mesh > 0) model.nodes[0].children.push_back(static_cast<int>(mesh));
  }
  tinygltf::Scene scene;
  scene.nodes.push_back(0);
  model.scenes.push_back(std::move(scene));
  model.defaultScene = 0;
}

/// Appends the meshes; targets: floats or integers.
AssetSplit append_meshes(tinygltf::Model& model, const Asset& asset, const GltfOptions& options,
                         auto targets) {
  AssetSplit split = options.split ? split_asset(asset, moved_vertices(targets)) : whole(asset);
  append_morph_mesh(model, asset, split.moving, std::move(targets));
  if (!split.still.empty()) append_still_mesh(model, asset, split.still);
  return split;
}

Built build(const Asset& asset, const GltfOptions& options, double strictness, Steps& steps) {
  const Clip& clip = asset.clip;
  Reduction reduction = reduce(clip, {normals_of(asset), strictness}, options, steps);
  Basis& basis = reduction.basis;
  check_glb_size(count_contents(asset, reduction.targets));

  tinygltf::Model model;
  model.buffers.emplace_back();
  append_materials(model, clip.mesh, asset.primitives, asset.textures);
  const AssetSplit split =
      options.encoding == Encoding::meshopt
          ? append_meshes(model, asset, options, quantize_targets(reduction, reduction.rounding))
          : append_meshes(model, asset, options, std::move(reduction.targets));
  append_scene(model);
  Built built;
  for (const WeightTrack& track : tracks_of(clip, basis, options)) {
    built.animations.push_back({static_cast<int>(model.animations.size()), track.from, track.to});
    append_weights_animation(model, track);
  }
  built.targets = static_cast<int>(basis.names.size());
  built.keys = static_cast<int>(basis.keys.size());
  built.vertices = split.note.vertices;
  if (options.split) built.splits.push_back(split.note);
  const Played played = played_by(model, asset, split);
  built.error = measure_playback(played, clip, basis, steps);
  built.pose_error = measure_poses(played, clip, options.poses, basis);
  built.extensions = model.extensionsRequired;
  built.warnings = asset.textures.warnings;
  describe(model, clip, basis, options, built.error);
  built.glb = glb_of(std::move(model));
  return built;
}

/// The integers' largest error is only known once they are there: a budget that proves too large is halved.
/// Floats, and one target a frame, would only come out the same again.
Built build_within_tolerance(const Clip& clip, const GltfOptions& options) {
  constexpr double least_strictness = 1.0 / 16;
  const std::optional<Asset> asset = options.source ? std::nullopt : std::optional(asset_of(clip, options));
  const std::size_t passes = options.normals ? 3 : 1;  // over the frames: two fit and measure the normals
  Steps steps(passes * clip.frames.size(), options.on_progress);
  const bool can_tighten = options.encoding == Encoding::meshopt && options.basis != BasisKind::frames;
  for (double strictness = 1;; strictness /= 2) {
    Built built = asset ? build(*asset, options, strictness, steps)
                        : build_into_source(clip, options, strictness, steps);
    const bool is_met = built.error.largest <= options.tolerance;
    if (is_met || !can_tighten || strictness <= least_strictness) return built;
  }
}

std::uintmax_t gpu_bytes(int vertices, int targets) {
  return kGpuBytes * static_cast<std::uintmax_t>(vertices) * static_cast<std::uintmax_t>(targets);
}

GltfReport report_on(const Built& built, const GltfOptions& options) {
  GltfReport report;
  report.profile = profile_name(options);
  report.targets = built.targets;
  report.vertices = built.vertices;
  report.keys = built.keys;
  report.error = built.error.largest;
  report.kg_error = built.error.kg;
  report.normal_error_mean = built.error.normal_mean;
  report.normal_error_largest = built.error.normal_largest;
  report.pose_error = built.pose_error;
  report.splits = built.splits;
  report.target_vertices = report.splits.empty() ? report.vertices : 0;
  for (const SplitNote& note : report.splits) report.target_vertices += note.targeted;
  report.gpu_bytes = gpu_bytes(report.target_vertices, report.targets);
  report.gpu_bytes_whole = gpu_bytes(report.vertices, report.targets);
  report.extensions = built.extensions;
  const bool has_meshopt = options.encoding == Encoding::meshopt;
  if (has_meshopt) report.extensions.emplace_back("EXT_meshopt_compression");
  report.clients = client_notes(report.targets, has_meshopt);
  report.warnings = built.warnings;
  return report;
}

void warn(const GltfOptions& options, GltfReport& report) {
  if (options.basis != BasisKind::frames && report.error > options.tolerance) {
    report.warnings.push_back(
        fmt::format("the file is off by {:.2g} of the diagonal, more than its tolerance of {:.2g}",
                    report.error, options.tolerance));
  }
  if (report.targets > kManyTargets) {
    report.warnings.push_back(
        fmt::format("{} morph targets take {:.0f} MiB of GPU memory, and many viewers are slow beyond 128",
                    report.targets, static_cast<double>(report.gpu_bytes) / (1 << 20)));
  }
}

/// A GLB that is ready to be written.
struct Finished {
  Glb glb;
  GltfReport report;  // without the bytes
};

Finished finish(const Clip& clip, const GltfOptions& options) {
  check_clip(clip);
  check_poses(clip, options.poses);
  Built built = build_within_tolerance(clip, options);
  if (!options.handles.empty())
    built.glb = graft(built.glb, add_handles(built.glb, clip, options.handles, built.animations));
  GltfReport report = report_on(built, options);
  warn(options, report);
  Glb glb = options.encoding == Encoding::meshopt ? meshopt_compressed(built.glb) : std::move(built.glb);
  return {std::move(glb), std::move(report)};
}

}  // namespace

std::string profile_name(const GltfOptions& options) {
  const auto [basis, encoding] = std::pair(options.basis, options.encoding);
  if (basis == BasisKind::knots) return encoding == Encoding::floats ? "compat" : "knots meshopt";
  if (basis == BasisKind::pca) return encoding == Encoding::floats ? "pca float" : "web";
  return encoding == Encoding::floats ? "exact" : "frames meshopt";
}

GltfReport write_glb(const Clip& clip, const GltfOptions& options, const std::filesystem::path& path) {
  Finished finished = finish(clip, options);
  finished.report.bytes = save_glb(finished.glb, path);
  return std::move(finished.report);
}

GlbFile make_glb(const Clip& clip, const GltfOptions& options) {
  Finished finished = finish(clip, options);
  GlbFile file;
  put_glb(finished.glb, [&](std::string_view bytes) { file.bytes += bytes; });
  file.report = std::move(finished.report);
  file.report.bytes = file.bytes.size();
  return file;
}

}  // namespace flexkey
