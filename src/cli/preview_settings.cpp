#include "cli/preview_settings.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>

#include "flexkey/timeline/sampling.h"
#include "flexkey/timeline/steps.h"

namespace flexkey::cli {
namespace {

Style style_of(PreviewOutput::Style style) {
  switch (style) {
    case PreviewOutput::Style::clay:
      return Style::clay;
    case PreviewOutput::Style::normals:
      return Style::normals;
    case PreviewOutput::Style::displacement:
      return Style::displacement;
    case PreviewOutput::Style::lambda:
      return Style::lambda;
    case PreviewOutput::Style::error:
      return Style::error;
    case PreviewOutput::Style::wire:
      return Style::wire;
    case PreviewOutput::Style::textured:
      break;
  }
  return Style::textured;
}

ImageFormat format_of(PreviewOutput::Format format) {
  switch (format) {
    case PreviewOutput::Format::png:
      return ImageFormat::png;
    case PreviewOutput::Format::exr:
      return ImageFormat::exr;
    case PreviewOutput::Format::webp:
      return ImageFormat::webp;
    case PreviewOutput::Format::jpg:
      break;
  }
  return ImageFormat::jpg;
}

Up up_of(const PreviewCamera& camera) {
  return camera.up == UpAxis::z ? Up::z : Up::y;
}

}  // namespace

CameraSettings camera_settings(const PreviewOutput& preview) {
  CameraSettings settings;
  settings.look_at = preview.camera.look_at;
  settings.azimuth = preview.camera.azimuth;
  settings.elevation = preview.camera.elevation;
  settings.fov = preview.camera.fov;
  settings.zoom = preview.camera.zoom;
  settings.up = up_of(preview.camera);
  if (preview.overlay)
    settings.footer = std::min(0.3, static_cast<double>(overlay_height(preview.height)) / preview.height);
  return settings;
}

RenderOptions render_options(const LoadedShot& loaded) {
  const PreviewOutput& preview = loaded.shot.preview;
  RenderOptions options;
  options.width = preview.width;
  options.height = preview.height;
  options.samples = preview.samples;
  options.subdivide = preview.subdivide;
  options.style = style_of(preview.style);
  options.quality = preview.quality == PreviewOutput::Quality::draft ? Quality::draft : Quality::final;
  options.up = up_of(preview.camera);
  options.weld = loaded.shot.mesh.weld.resolve(bounds_of(loaded.mesh.positions).diagonal());
  return options;
}

PictureSequence sequence_of(const PreviewOutput& preview, const ShotOptions& options) {
  return {options.out_dir / preview.dir, format_of(preview.format)};
}

std::vector<int> drawn_frames(const Shot& run, const ShotOptions& options) {
  std::vector<int> named = frames_in(run.preview.frames);
  if (named.empty()) {
    named.resize(static_cast<std::size_t>(run.frame_count()));
    std::iota(named.begin(), named.end(), 0);
  }
  const std::vector<int> picked = parse_frames(options.frames, run.frame_count());
  if (picked.empty()) return named;
  std::vector<int> drawn;
  std::set_intersection(named.begin(), named.end(), picked.begin(), picked.end(), std::back_inserter(drawn));
  return drawn;
}

std::vector<Moment> moments_of(const Shot& run) {
  std::vector<Moment> moments;
  for (int k = 0; k < run.frame_count(); ++k)
    moments.push_back({k, k / run.fps, sample_lambda(run.lambda, time_of_frame(run, k))});
  return moments;
}

}  // namespace flexkey::cli
