#include "cli/preview_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/preview_settings.h"
#include "cli/sweep_runs.h"
#include "flexkey/preview/images/draw.h"
#include "flexkey/preview/images/gif.h"
#include "flexkey/preview/images/image_file.h"
#include "flexkey/preview/images/resize.h"
#include "flexkey/preview/images/sheet.h"
#include "flexkey/timeline/sampling.h"
#include "flexkey/timeline/steps.h"

namespace flexkey::cli {
namespace {

constexpr int usual_cell_width = 480;  // pixels
constexpr int widest_sheet = 16'000;
constexpr std::size_t usual_cells = 4;

/// The frame of `drawn` that is nearest to a time.
int nearest_frame(const std::vector<int>& drawn, double time, double fps) {
  return *std::min_element(drawn.begin(), drawn.end(),
                           [&](int a, int b) { return std::abs(a / fps - time) < std::abs(b / fps - time); });
}

/// The frames on a sheet.
std::vector<int> sheet_frames(const Shot& run, const std::vector<int>& drawn) {
  std::vector<int> frames;
  for (const MarkedTime& moment : run.preview.sheet.at)
    frames.push_back(nearest_frame(drawn, moment.time, run.fps));
  const std::size_t count = std::min(usual_cells, drawn.size());
  for (std::size_t k = 0; frames.size() < count && run.preview.sheet.at.empty(); ++k)
    frames.push_back(drawn[count == 1 ? 0 : k * (drawn.size() - 1) / (count - 1)]);
  return frames;
}

int cell_width(const PreviewOutput& preview, int columns) {
  const int wanted = preview.sheet.width.value_or(std::min(usual_cell_width, preview.width));
  return std::max(1, std::min(wanted, widest_sheet / columns));
}

/// A picture of a sheet: without its overlay, whose numbers the sheet's labels give.
Picture cell_of(const Shot& run, int frame, int width, const ShotOptions& options) {
  const PreviewOutput& preview = run.preview;
  Picture whole = read_picture(frame_path(sequence_of(preview, options), frame));
  if (preview.overlay && whole.height > 2 * overlay_height(whole.height)) {
    Picture cut = blank_picture(whole.width, whole.height - overlay_height(whole.height), Rgb::Zero());
    paste(cut, whole, 0, 0);
    whole = std::move(cut);
  }
  return resized_to_width(whole, width);
}

std::string time_label(const Shot& run, int frame) {
  return fmt::format("{:.3g} s", frame / run.fps);
}

std::string lambda_label(const Shot& run, int frame) {
  return fmt::format("λ = {:.2g}", sample_lambda(run.lambda, time_of_frame(run, frame)));
}

}  // namespace

void write_gif_of(const Shot& run, const ShotOptions& options) {
  const PreviewOutput& preview = run.preview;
  const std::vector<int> drawn = drawn_frames(run, options);
  if (drawn.empty()) return;
  GifWriter gif(options.out_dir / preview.gif.path);
  for (const int frame : drawn) {
    const Picture picture = read_picture(frame_path(sequence_of(preview, options), frame));
    gif.add(resized_to_width(picture, preview.gif.width.value_or(picture.width)), frame / run.fps);
  }
  const int step = drawn.size() > 1 ? drawn.back() - drawn[drawn.size() - 2] : 1;
  gif.finish((drawn.back() + step) / run.fps);
}

void write_sheet_of(const std::vector<const Shot*>& runs, const ShotOptions& options) {
  const Shot& first = **std::min_element(runs.begin(), runs.end(), [](const Shot* a, const Shot* b) {
    return a->frame_count() < b->frame_count();  // every run has its frames
  });
  const std::vector<int> frames = sheet_frames(first, drawn_frames(first, options));
  if (frames.empty()) return;
  const bool is_sweep = runs.size() > 1;
  Sheet sheet;
  sheet.columns = static_cast<int>(is_sweep ? runs.size() : frames.size());
  const int width = cell_width(first.preview, sheet.columns);
  for (const int frame : frames) {
    for (const Shot* run : runs) sheet.cells.push_back(cell_of(*run, frame, width, options));
    if (is_sweep && frames.size() > 1) {
      sheet.row_labels.push_back(time_label(first, frame));
    } else if (!is_sweep) {
      sheet.column_labels.push_back(
          fmt::format("{},  {}", time_label(first, frame), lambda_label(first, frame)));
    }
  }
  if (is_sweep)
    for (const Shot* run : runs) sheet.column_labels.push_back(run_title(run->swept));
  write_picture(draw_sheet(sheet), options.out_dir / first.preview.sheet.path);
}

}  // namespace flexkey::cli
