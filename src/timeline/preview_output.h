#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "flexkey/mesh/selection.h"
#include "flexkey/timeline/frame_ranges.h"

namespace flexkey {

/// The axis that points upwards.
enum class UpAxis { y, z };

/// Where pictures are taken from. Angles in radians, lengths in mesh units.
struct PreviewCamera {
  std::optional<Vec3> look_at;
  double azimuth = 35 * std::numbers::pi / 180;
  double elevation = 15 * std::numbers::pi / 180;
  double fov = 30 * std::numbers::pi / 180;
  double zoom = 1;
  enum class Fit { clip, rest };
  Fit fit = Fit::clip;       // what the picture holds: all frames, or the mesh at rest
  std::optional<UpAxis> up;  // default the mesh's
};

/// An animated GIF of the pictures; path is empty where none is asked for.
struct GifOutput {
  std::string path;  // as the timeline gives it, placeholders and all
  Mark where;
  std::optional<int> width;  // pixels; default the pictures'
};

/// A time of the shot, seconds.
struct MarkedTime {
  double time = 0;
  Mark where;
};

/// Pictures side by side; path is empty where no sheet is asked for.
struct SheetOutput {
  std::string path;  // as the timeline gives it; runs of a sweep with one path share the sheet
  Mark where;
  std::vector<MarkedTime> at;  // empty: evenly over the clip
  std::optional<int> width;    // of a picture in it, pixels
};

/// What output.preview says; dir is empty where no pictures are asked for. The terms are the renderer's.
struct PreviewOutput {
  std::string dir;  // folder of 0000.png, 0001.png …, placeholders and all
  Mark where;
  int width = 960, height = 540;  // pixels
  int samples = 8;                // a pixel
  int subdivide = 2;
  std::vector<FrameRange> frames;  // empty: all
  enum class Format { png, exr, webp, jpg };
  Format format = Format::png;
  PreviewCamera camera;
  double turntable = 0;  // turns over the clip
  enum class Style { clay, normals, displacement, lambda, error, wire, textured };
  Style style = Style::clay;
  enum class Quality { draft, final };
  Quality quality = Quality::final;
  enum class Handles { none, borders, all };
  Handles handles = Handles::none;  // whose vertices are marked
  bool overlay = false;             // time, frame and λ along the lower edge
  GifOutput gif;
  SheetOutput sheet;
};

/// Whether any picture depends on every frame of the clip.
inline bool needs_whole_clip(const PreviewOutput& preview) {
  return !preview.dir.empty() && (preview.camera.fit == PreviewCamera::Fit::clip ||
                                  preview.style == PreviewOutput::Style::displacement);
}

}  // namespace flexkey
