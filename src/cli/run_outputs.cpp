#include "cli/run_outputs.h"

#include <fmt/format.h>

#include <utility>

#include "cli/conclusion.h"
#include "cli/gltf_options.h"
#include "cli/html_page.h"
#include "cli/interrupt.h"
#include "cli/pose_outputs.h"
#include "cli/previews.h"
#include "cli/stopwatch.h"
#include "cli/upright.h"
#include "flexkey/gltf/write_glb.h"
#include "flexkey/mesh/output_file.h"

namespace flexkey::cli {

void require_outputs(const Session& session) {
  const ShotOptions& options = session.options;
  const LoadedShot& loaded = session.loaded;
  const std::vector<Shot>& runs = session.runs;
  const std::vector<std::filesystem::path> paths = plan_outputs(loaded, options, runs);
  check_pose_outputs(loaded, options);
  check_caches(loaded, options, runs);
  check_pages(loaded, options, runs);
  check_previews(loaded, options, runs);
  const Shot& shot = loaded.shot;
  check_report(session);
  if (paths.empty() && shot.caches.empty() && shot.html.path.empty() && shot.preview.dir.empty())
    throw UsageError(
        fmt::format("{} names no output; add 'output: {}.glb'", loaded.shot.file, loaded.shot.name));
  for (const std::filesystem::path& path : paths)
    OutputFile probe(path);  // made and, uncommitted, removed again
  probe_caches(loaded, options, runs);
  probe_pages(options, runs);
  probe_previews(options, runs);
}

bool needs_clip(const Shot& shot) {
  return !shot.gltf.path.empty() || !shot.html.path.empty();
}

RunOutputs::RunOutputs(const Session& session, std::size_t run)
    : session_(session), run_(session.runs[run]), caches_(session.loaded, session.options, run_) {
  if (run_.gltf.handles) handles_ = handle_tracks(session.scene);
}

void RunOutputs::add(const SolvedFrame& frame) {
  caches_.add(frame);
  for (std::size_t h = 0; h < handles_.size(); ++h) handles_[h].matrices.push_back(frame.handles[h]);
}

bool RunOutputs::finish(RunFrames& frames) {
  std::vector<PoseShape> poses = solve_pose_shapes(session_, run_, frames.report);
  if (noted_signal() != 0) return false;
  frames.report.caches = caches_.finish();
  if (needs_clip(run_)) write_clip(frames, std::move(poses));
  return true;
}

void RunOutputs::write_clip(RunFrames& frames, std::vector<PoseShape> poses) {
  auto& [clip, report] = frames;
  const ShotOptions& options = session_.options;
  const int count = static_cast<int>(clip.frames.size());
  Progress progress(count, verbosity_of(options), "Writing");
  GltfOptions gltf = gltf_options(run_, session_.loaded);
  gltf.handles = std::move(handles_);
  gltf.poses = std::move(poses);
  stand_upright(run_.mesh.up, clip, gltf);
  gltf.on_progress = [&](double share) { progress.reach(static_cast<int>(share * count)); };
  if (!run_.gltf.path.empty()) {
    const Stopwatch watch;
    const std::filesystem::path path = options.out_dir / run_.gltf.path;
    report.written.push_back({path, write_glb(clip, gltf, path)});
    report.write_seconds = watch.seconds();
  }
  if (!run_.html.path.empty())
    report.pages.push_back(write_html_page({run_, session_.scene, clip}, gltf,
                                           options.out_dir / run_.html.path, report.written));
}

std::vector<std::string> RunOutputs::fates() const {
  std::vector<std::string> fates = caches_.fates();
  for (const std::string& path : {run_.html.path, run_.gltf.path})
    if (!path.empty())
      fates.insert(fates.begin(),
                   fmt::format("'{}' was not written", (session_.options.out_dir / path).string()));
  return fates;
}

}  // namespace flexkey::cli
