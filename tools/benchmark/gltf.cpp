#include "gltf.h"

#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <functional>
#include <optional>
#include <system_error>

#include "flexkey/animate/animate.h"
#include "flexkey/mesh/error.h"
#include "flexkey/mesh/read_mesh.h"
#include "flexkey/timeline/parse.h"
#include "motion.h"
#include "played_glb.h"
#include "scratch.h"

namespace flexkey::bench {
namespace {

namespace fs = std::filesystem;

constexpr int blob_cells = 50;  // 10,002 vertices

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double seconds_of(const std::function<void()>& work) {
  const double start = cpu_seconds();
  work();
  return cpu_seconds() - start;
}

Clip solve_blob(int frames) {
  const Motion motion = blob_there_and_back(blob_cells, frames);
  const Deformer deformer(motion.mesh, motion.constraints, {});
  Clip clip;
  clip.name = "blob";
  clip.mesh = motion.mesh;
  Pose pose = deformer.rest_pose();
  for (const Targets& targets : motion.frames) {
    const SolveReport report = deformer.solve(targets, 0.5, pose);
    clip.reports.push_back({.frame = static_cast<int>(clip.frames.size()),
                            .lambda = 0.5,
                            .solves = report.solves,
                            .estimate = report.estimate,
                            .converged = report.converged});
    clip.frames.push_back(pose.positions);
  }
  return clip;
}

Clip solve_shot(const fs::path& timeline) {
  const Shot shot = parse_shot(read_timeline(timeline), timeline).shot;
  return animate(shot, read_mesh(timeline.parent_path() / shot.mesh.file).mesh);
}

Written write(const Clip& clip, const GltfOptions& options, const fs::path& path) {
  Written written;
  written.seconds = seconds_of([&] { written.report = write_glb(clip, options, path); });
  return written;
}

GltfOptions web_options() {
  GltfOptions web;
  web.basis = BasisKind::pca;
  web.encoding = Encoding::meshopt;
  return web;
}

/// What gltfpack makes of a clip's dense file; none where it is not installed.
std::optional<Packed> packed(const fs::path& dense, const std::string& options, const Clip& clip) {
  const fs::path path = dense.parent_path() / "packed.glb";
  const std::string command =
      fmt::format("node tools/benchmark/node_modules/.bin/gltfpack {} -kn -i '{}' -o '{}' >/dev/null 2>&1",
                  options, dense.string(), path.string());
  if (std::system(command.c_str()) != 0) return {};  // NOLINT(concurrency-mt-unsafe): nothing else runs
  return Packed{options, static_cast<double>(fs::file_size(path)), error_of(path, clip), {}};
}

/// With the fewest bits a coordinate that are within the default tolerance.
std::optional<Packed> coarsely_packed(const fs::path& dense, const Clip& clip) {
  constexpr int most_bits = 16;
  for (int bits = 8; bits <= most_bits; ++bits) {
    std::optional<Packed> result = packed(dense, fmt::format("-cc -af 0 -vp {}", bits), clip);
    if (!result || result->error <= GltfOptions().tolerance) return result;
  }
  return {};
}

std::vector<Packed> packed_beside_web(const fs::path& dense, const Clip& clip) {
  std::vector<Packed> all;
  for (std::optional<Packed> one :
       {packed(dense, "-cc", clip), packed(dense, "-cc -af 0", clip), coarsely_packed(dense, clip)}) {
    if (!one) continue;
    GltfOptions web = web_options();
    web.tolerance = one->error;
    one->web = write(clip, web, dense.parent_path() / "near.glb");
    all.push_back(std::move(*one));
  }
  return all;
}

GltfResult measure_clip(const std::string& name, const std::function<Clip()>& solve) {
  GltfResult result;
  Clip clip;
  result.solve_seconds = seconds_of([&] { clip = solve(); });
  const Scratch scratch;
  GltfOptions dense;
  dense.basis = BasisKind::frames;
  dense.max_targets = static_cast<int>(clip.frames.size());
  const GltfReport whole = write_glb(clip, dense, scratch / "dense.glb");
  result.name = name;
  result.frames = static_cast<int>(clip.frames.size());
  result.vertices = whole.vertices;
  constexpr double floats = 4, numbers = 6;  // of a position and a normal
  result.dense = floats * numbers * whole.vertices * (1.0 + result.frames);
  result.compat = write(clip, {}, scratch / "compat.glb");
  result.web = write(clip, web_options(), scratch / "web.glb");
  result.packed = packed_beside_web(scratch / "dense.glb", clip);
  return result;
}

}  // namespace

std::vector<GltfResult> measure_gltf(const fs::path& timelines) {
  std::vector<GltfResult> results;
  for (const int frames : {100, 240})
    results.push_back(measure_clip("blob", [&] { return solve_blob(frames); }));
  for (const char* shot : {"nose", "leg", "jaw", "twist"}) {
    const fs::path timeline = timelines / fmt::format("{}.yaml", shot);
    results.push_back(measure_clip(shot, [&] { return solve_shot(timeline); }));
  }
  return results;
}

}  // namespace flexkey::bench
