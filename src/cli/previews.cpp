#include "cli/previews.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "cli/behind.h"
#include "cli/interrupt.h"
#include "cli/picture_maker.h"
#include "cli/preview_files.h"
#include "cli/preview_settings.h"
#include "cli/progress.h"
#include "cli/stopwatch.h"
#include "flexkey/preview/clip_extent.h"
#include "flexkey/preview/images/image_file.h"
#include "flexkey/preview/images/module.h"
#include "flexkey/timeline/steps.h"

namespace flexkey::cli {
namespace {

/// The pictures of one run on their way.
struct RunPictures {
  PictureRun of;
  PictureSequence sequence;
  std::vector<int> drawn;            // frames
  const TakeState* state = nullptr;  // which has the solved frames; null: the spool has those that wait
  std::unique_ptr<FrameSpool> spool;
  std::optional<ClipExtent> extent;
  WrittenPreview report;

  KeptFrame frame(int number) const {
    if (state == nullptr) return spool->frame(number);
    const int step = step_of(of.shot, number);
    KeptFrame kept{state->report(step), state->positions(step)};
    kept.report.frame = number;
    return kept;
  }
};

RunPictures pictures_of(const Session& session, std::size_t number, const TakeState* state) {
  const Shot& run = session.runs[number];
  RunPictures pictures{{run, moments_of(run)},
                       sequence_of(run.preview, session.options),
                       drawn_frames(run, session.options),
                       state,
                       {},
                       {},
                       {}};
  WrittenPreview& report = pictures.report;
  report.path = pictures.sequence.folder / fmt::format("%04d.{}", name_of(pictures.sequence.format));
  report.format = name_of(pictures.sequence.format);
  if (pictures.drawn.empty() || !needs_whole_clip(run.preview)) return pictures;
  const Mesh& mesh = session.loaded.mesh;
  if (state == nullptr) pictures.spool = std::make_unique<FrameSpool>(report.path, mesh.vertex_count());
  pictures.extent.emplace(camera_settings(run.preview), mesh.positions);
  return pictures;
}

/// The sheets whose last runs are those of this session, and the runs that share each. Those that runs of
/// another chunk share are left out.
std::map<std::string, std::vector<const Shot*>> finished_sheets(const Session& session) {
  std::set<int> drawn;
  for (std::size_t family = 0; family <= session.family; ++family)
    for (const Shot& run : session.timeline.families[family]) drawn.insert(run.run);
  std::map<std::string, std::vector<const Shot*>> sheets;
  for (const Shot& run : session.runs)
    if (!run.preview.sheet.path.empty()) sheets[run.preview.sheet.path];
  for (const Shot& run : session.timeline.runs) {
    const auto found = sheets.find(run.preview.sheet.path);
    if (found == sheets.end()) continue;
    found->second.push_back(&run);
    if (!drawn.contains(run.run)) sheets.erase(found);
  }
  return sheets;
}

}  // namespace

struct Previews::Impl {
  const Session& session;
  const RunStates& states;
  std::vector<RunPictures> runs;
  std::optional<PictureMaker> maker;
  double seconds = 0;       // of drawing and writing, beside the solve or not
  Behind writing, drawing;  // a picture that is drawn waits for the one before to be written

  void draw(RunPictures& pictures, const KeptFrame& frame);
  void draw_waiting();
  void make_files();
};

/// Draws a frame behind the caller's back, and writes it behind that of the next.
void Previews::Impl::draw(RunPictures& pictures, const KeptFrame& frame) {
  drawing.start([this, &pictures, frame] {
    const Stopwatch watch;
    const int number = frame.report.frame;
    const std::filesystem::path path = frame_path(pictures.sequence, number);
    const PictureTags tags{maker->inputs(frame, pictures.of), number, number / pictures.of.shot.fps,
                           frame.report.lambda};
    if (was_made_from(path, tags.inputs)) {
      ++pictures.report.kept;
    } else {
      writing.start([&pictures, path, tags, picture = maker->draw(frame, pictures.of)] {
        write_picture(picture, path, tags);
        ++pictures.report.drawn;
      });
    }
    seconds += watch.seconds();
  });
}

/// Draws the frames that have waited for the last.
void Previews::Impl::draw_waiting() {
  std::optional<ClipExtent> extent;
  int total = 0;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    RunPictures& pictures = runs[run];
    if (!pictures.extent) continue;
    if (pictures.state != states.kept(run))
      throw OutputError("cannot draw pictures: their frames could not be kept until the last was solved");
    if (extent) extent->join(*pictures.extent);
    if (!extent) extent = std::move(pictures.extent);
    total += static_cast<int>(pictures.drawn.size());
  }
  if (!extent) return;
  const LoadedShot& loaded = session.loaded;
  const bool holds_clip = loaded.shot.preview.camera.fit == PreviewCamera::Fit::clip;
  maker.emplace(loaded, session.scene,
                Framing{holds_clip ? extent->outline() : loaded.mesh.positions, extent->largest_offset()});
  Progress progress(total, verbosity_of(session.options), "Rendering");
  for (RunPictures& pictures : runs) {
    for (const int number : pictures.drawn) {
      if (noted_signal() != 0) return;
      draw(pictures, pictures.frame(number));
      progress.advance();
    }
    drawing.finish();
    pictures.spool.reset();
  }
}

void Previews::Impl::make_files() {
  if (session.options.part) return;  // whoever draws all frames makes them of these too
  for (RunPictures& pictures : runs) {
    const PreviewOutput& preview = pictures.of.shot.preview;
    if (preview.gif.path.empty() || noted_signal() != 0) continue;
    write_gif_of(pictures.of.shot, session.options);
    pictures.report.files.push_back(session.options.out_dir / preview.gif.path);
  }
  for (const auto& [path, sharing] : finished_sheets(session)) {
    if (noted_signal() != 0) return;
    write_sheet_of(sharing, session.options);
    runs.back().report.files.push_back(session.options.out_dir / path);
  }
}

bool draws_previews() {
  return true;
}

void preload_previews() {
  image_module();
}

Previews::Previews(const Session& session, const RunStates& states)
    : impl_(new Impl{session, states, {}, {}, 0, {}, {}}) {
  const LoadedShot& loaded = session.loaded;
  if (loaded.shot.preview.dir.empty()) return;
  for (std::size_t run = 0; run < session.runs.size(); ++run)
    impl_->runs.push_back(pictures_of(session, run, states.kept(run)));
  if (needs_whole_clip(loaded.shot.preview)) return;
  impl_->maker.emplace(loaded, session.scene, Framing{loaded.mesh.positions});
}

Previews::~Previews() = default;

void Previews::add(std::size_t run, const SolvedFrame& frame) {
  if (impl_->runs.empty()) return;
  RunPictures& pictures = impl_->runs[run];
  if (pictures.extent) pictures.extent->add(frame.positions);
  if (!std::binary_search(pictures.drawn.begin(), pictures.drawn.end(), frame.report.frame)) return;
  if (!pictures.extent) impl_->draw(pictures, {frame.report, frame.positions});
  if (pictures.spool) pictures.spool->add(frame);
}

std::vector<WrittenPreview> Previews::finish() {
  impl_->draw_waiting();
  impl_->drawing.finish();
  impl_->writing.finish();
  const Stopwatch watch;
  if (impl_->session.picked.empty() && noted_signal() == 0) impl_->make_files();
  impl_->seconds += watch.seconds();
  std::vector<WrittenPreview> written;
  for (RunPictures& pictures : impl_->runs) {
    pictures.report.seconds = impl_->seconds / static_cast<double>(impl_->runs.size());
    if (pictures.drawn.size() > 1)
      pictures.report.ffmpeg = ffmpeg_line(pictures.sequence, pictures.drawn, pictures.of.shot.fps);
    written.push_back(pictures.report);
  }
  return written;
}

std::vector<std::string> Previews::warnings() const {
  return impl_->maker ? impl_->maker->warnings() : std::vector<std::string>();
}

std::vector<std::string> Previews::fates() const {
  impl_->drawing.finish();
  impl_->writing.finish();
  std::vector<std::string> fates;
  for (const RunPictures& pictures : impl_->runs)
    fates.push_back(fmt::format("'{}' has {} of {} pictures", pictures.report.path.string(),
                                pictures.report.drawn + pictures.report.kept, pictures.drawn.size()));
  return fates;
}

}  // namespace flexkey::cli
