#include "flexkey/gltf/write_glb.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <span>
#include <utility>

#include "flexkey/gltf/asset.h"
#include "flexkey/gltf/check_clip.h"
#include "flexkey/gltf/extras.h"
#include "flexkey/gltf/fit_targets.h"
#include "flexkey/gltf/glb.h"
#include "flexkey/gltf/knot_basis.h"
#include "flexkey/gltf/materials.h"
#include "flexkey/gltf/measure.h"
#include "flexkey/gltf/meshopt.h"
#include "flexkey/gltf/morphs.h"
#include "flexkey/gltf/pca_basis.h"
#include "flexkey/gltf/quantize.h"
#include "flexkey/gltf/size_estimate.h"
#include "flexkey/gltf/steps.h"
#include "flexkey/gltf/utf8.h"
#include "flexkey/gltf/weight_tracks.h"
#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

constexpr int kManyTargets = 128;
// Normals that never turn by a tenth of a degree stay as they are at rest.
constexpr double kStillNormal = 0.0017;
constexpr std::uintmax_t kGpuBytes = 32;  // of a target's position and normal in a client's texture

/// How much of the tolerance the basis may spend, and how much the integers do, as a distance that they add
/// on average: their largest is about three times that.
struct Budget {
  double basis = 1;
  double integers = 0;
};

Budget budget_of(const GltfOptions& options, double strictness) {
  if (options.encoding == Encoding::floats) return {1, 0};
  return {0.8 * strictness, 0.06 * strictness};
}

Basis basis_of(const Motion& motion, const GltfOptions& options, double tolerance) {
  switch (options.basis) {
    case BasisKind::knots:
      return knot_basis(motion, tolerance);
    case BasisKind::pca: {
      Basis basis = pca_basis(motion, tolerance);
      return options.encoding == Encoding::floats ? with_weights_in_unit_range(basis) : basis;
    }
    case BasisKind::frames:
      break;
  }
  return frame_basis(motion);
}

std::vector<FloatRows> normal_targets(const Asset& asset, const Basis& basis, std::span<const int> numbers,
                                      Steps& steps) {
  const auto normals_of = [&](std::size_t frame) {
    steps.advance();
    return asset.normals->at(asset.clip.frames[frame]);
  };
  return fit_targets(basis, numbers, asset.normals->at(asset.clip.mesh.positions), normals_of, kStillNormal);
}

void require_allowed(const Basis& basis, const GltfOptions& options) {
  const std::size_t targets = basis.targets.size();
  if (targets <= static_cast<std::size_t>(options.max_targets)) return;
  throw InputError(
      fmt::format("the clip takes {} morph targets as '{}', and at most {} are allowed (max_targets); most "
                  "viewers stop at "
                  "256. A larger tolerance, or the profile 'compat' or 'web', takes fewer",
                  targets, profile_name(options), options.max_targets));
}

/// glTF animates no weights of a mesh without targets.
void require_one_target(Basis& basis, Eigen::Index vertex_count) {
  if (!basis.targets.empty()) return;
  basis.targets.emplace_back(FloatRows::Zero(vertex_count, 3));
  basis.names.emplace_back("still");
  basis.weights = Eigen::MatrixXf::Zero(static_cast<Eigen::Index>(basis.keys.size()), 1);
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

/// Quantizes the targets; their scales become part of the weights.
QuantizedTargets quantize_into(Eigen::MatrixXf& weights, const Targets& targets, double length) {
  QuantizedTargets quantized = quantize(targets, weights, {.length = length});
  const Eigen::Map<const Eigen::RowVectorXf> scales(quantized.scales.data(), weights.cols());
  weights.array().rowwise() *= scales.array();
  return quantized;
}

/// A model and what it plays.
struct Built {
  tinygltf::Model model;
  PlaybackError error;
  int keys = 0;
};

Built build(const Asset& asset, const GltfOptions& options, double strictness, Steps& steps) {
  const Clip& clip = asset.clip;
  const double tolerance = options.tolerance * bounds_of(clip.mesh.positions).diagonal();
  const Budget budget = budget_of(options, strictness);
  std::vector<int> numbers;
  for (const FrameReport& report : clip.reports) numbers.push_back(report.frame);
  Basis basis = basis_of({clip.frames, clip.mesh.positions, numbers}, options, budget.basis * tolerance);
  require_allowed(basis, options);
  require_one_target(basis, clip.mesh.positions.rows());
  Targets targets;
  if (asset.normals) targets.normals = normal_targets(asset, basis, numbers, steps);
  targets.positions = std::move(basis.targets);
  check_glb_size(count_contents(asset, targets));

  Built built;
  built.model.buffers.emplace_back();
  append_materials(built.model, clip.mesh, asset.primitives, asset.textures);
  if (options.encoding == Encoding::meshopt) {
    append_morph_mesh(built.model, asset, quantize_into(basis.weights, targets, budget.integers * tolerance));
  } else {
    append_morph_mesh(built.model, asset, std::move(targets));
  }
  append_scene(built.model, clip);
  for (const WeightTrack& track : weight_tracks(clip, basis, options.clips))
    append_weights_animation(built.model, track);
  built.keys = static_cast<int>(basis.keys.size());
  built.error = measure_playback(built.model, asset, basis, steps);
  describe(built.model, clip, basis, options, built.error);
  return built;
}

/// The integers' largest error is only known once they are there: a budget that proves too large is halved.
Built build_within_tolerance(const Asset& asset, const GltfOptions& options) {
  constexpr double least_strictness = 1.0 / 16;
  const std::size_t passes = asset.normals ? 3 : 1;  // over the frames: two fit and measure the normals
  Steps steps(passes * asset.clip.frames.size(), options.on_progress);
  for (double strictness = 1;; strictness /= 2) {
    Built built = build(asset, options, strictness, steps);
    const bool is_met = options.basis == BasisKind::frames || built.error.largest <= options.tolerance;
    if (is_met || strictness <= least_strictness) return built;
  }
}

GltfReport report_on(const Built& built, const Asset& asset, const GltfOptions& options) {
  GltfReport report;
  report.profile = profile_name(options);
  report.targets = static_cast<int>(built.model.meshes[0].weights.size());
  for (const Primitive& primitive : asset.primitives)
    report.vertices += static_cast<int>(primitive.vertices.size());
  report.keys = built.keys;
  report.error = built.error.largest;
  report.kg_error = built.error.kg;
  report.normal_error_mean = built.error.normal_mean;
  report.normal_error_largest = built.error.normal_largest;
  report.gpu_bytes =
      kGpuBytes * static_cast<std::uintmax_t>(report.vertices) * static_cast<std::uintmax_t>(report.targets);
  report.extensions = built.model.extensionsRequired;
  const bool has_meshopt = options.encoding == Encoding::meshopt;
  if (has_meshopt) report.extensions.emplace_back("EXT_meshopt_compression");
  report.clients = client_notes(report.targets, has_meshopt);
  report.warnings = asset.textures.warnings;
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

}  // namespace

std::string profile_name(const GltfOptions& options) {
  const auto [basis, encoding] = std::pair(options.basis, options.encoding);
  if (basis == BasisKind::knots) return encoding == Encoding::floats ? "compat" : "knots meshopt";
  if (basis == BasisKind::pca) return encoding == Encoding::floats ? "pca float" : "web";
  return encoding == Encoding::floats ? "exact" : "frames meshopt";
}

GltfReport write_glb(const Clip& clip, const GltfOptions& options, const std::filesystem::path& path) {
  check_clip(clip);
  const Asset asset = asset_of(clip, options);
  Built built = build_within_tolerance(asset, options);
  GltfReport report = report_on(built, asset, options);
  warn(options, report);
  Glb glb = glb_of(std::move(built.model));
  if (options.encoding == Encoding::meshopt) glb = meshopt_compressed(glb);
  report.bytes = save_glb(glb, path);
  return report;
}

}  // namespace flexkey
