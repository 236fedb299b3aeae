#include "cli/html_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <utility>

#include "cli/output_paths.h"
#include "cli/stopwatch.h"
#include "cli/upright.h"
#include "flexkey/animate/handle_states.h"
#include "flexkey/mesh/output_file.h"
#include "flexkey/mesh/read_file.h"
#include "flexkey/timeline/parse.h"
#include "flexkey/timeline/sampling.h"
#include "flexkey/timeline/steps.h"

namespace flexkey::cli {
namespace {

namespace fs = std::filesystem;

constexpr Eigen::Index most_points = 12;  // along a chain

std::string fault_of(const Shot& run, const LoadedShot& loaded, const ShotOptions& options) {
  const fs::path path = options.out_dir / run.html.path;
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension != ".html" && !is_special(path))
    return fmt::format("the output '{}' is a page and must end in '.html'", path.string());
  if (replaces_input(loaded, path))
    return fmt::format("the output '{}' would replace an input; give it another name", path.string());
  return {};
}

/// Points of a chain, evenly by number, its ends included.
Positions thinned(const Positions& chain) {
  const Eigen::Index count = std::min(chain.rows(), most_points);
  Positions points(count, 3);
  for (Eigen::Index i = 0; i < count; ++i)
    points.row(i) = chain.row(count > 1 ? i * (chain.rows() - 1) / (count - 1) : 0);
  return points;
}

Positions marks_of(const SolvedRun& run, const HandleStates& states, std::size_t h) {
  const Positions targets = targets_of(run.scene, states, static_cast<int>(h));
  const bool is_chain = !run.scene.handles[h].handle.curve.empty();
  const Positions marks = is_chain ? thinned(targets) : Positions(targets.colwise().mean());
  return run.shot.mesh.up == UpAxis::z ? upright(marks) : marks;
}

/// When the named clips begin, as the GLB has them: those that began before its first frame begin with it.
std::vector<PageClip> page_clips(const Shot& shot, const Clip& clip) {
  const double first = clip.reports.front().frame / clip.fps;
  std::vector<PageClip> clips;
  for (const NamedInterval& part : shot.clips)
    clips.push_back({part.name, std::max(part.time.from - first, 0.0)});
  return clips;
}

GlbFile glb_for_page(const SolvedRun& run, GltfOptions options, const std::vector<WrittenFile>& written) {
  if (!written.empty() && !is_special(written.front().path))
    return {read_file(written.front().path), written.front().gltf};
  if (run.shot.gltf.path.empty()) {
    options.basis = BasisKind::pca;
    options.encoding = Encoding::meshopt;
  }
  return make_glb(run.clip, options);
}

}  // namespace

void check_pages(const LoadedShot& loaded, const ShotOptions& options, const std::vector<Shot>& runs) {
  for (const Shot& run : runs) {
    const std::string fault = run.html.path.empty() ? "" : fault_of(run, loaded, options);
    if (!fault.empty())
      throw TimelineError(loaded.shot.file, {error_at(run.html.where, fault, options.overrides())});
  }
}

void probe_pages(const ShotOptions& options, const std::vector<Shot>& runs) {
  for (const Shot& run : runs)
    if (const fs::path path = options.out_dir / run.html.path; !run.html.path.empty() && !is_special(path))
      OutputFile probe(path);  // made and, uncommitted, removed again
}

std::vector<PageHandle> page_handles(const SolvedRun& run) {
  const auto& [shot, scene, clip] = run;
  std::vector<PageHandle> handles;
  for (const SceneHandle& bound : scene.handles)
    handles.push_back({bound.handle.name, bound.handle.is_anchor(), {}});
  for (const FrameReport& report : clip.reports) {
    const double time = time_of_frame(shot, report.frame);
    const HandleStates states = sample_states(scene, time);
    for (std::size_t h = 0; h < handles.size(); ++h)
      handles[h].points.push_back(is_active(scene.handles[h].handle, time) ? marks_of(run, states, h)
                                                                           : Positions(0, 3));
  }
  return handles;
}

WrittenPage write_html_page(const SolvedRun& run, const GltfOptions& gltf, const fs::path& path,
                            const std::vector<WrittenFile>& written) {
  const Stopwatch watch;
  GlbFile glb = glb_for_page(run, gltf, written);
  const PageContents contents{std::move(glb.bytes), page_handles(run), page_clips(run.shot, run.clip)};
  WrittenPage page;
  page.path = path;
  page.gltf = std::move(glb.report);
  page.bytes = write_page(run.clip, contents, page.path);
  page.seconds = watch.seconds();
  return page;
}

}  // namespace flexkey::cli
