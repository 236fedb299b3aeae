#include "cli/shot_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/handle_paths.h"
#include "cli/mesh_input.h"
#include "cli/output_paths.h"
#include "cli/preview_marks.h"
#include "cli/preview_settings.h"
#include "flexkey/animate/handle_states.h"
#include "flexkey/preview/images/image_file.h"
#include "flexkey/preview/images/labels.h"
#include "flexkey/preview/renderer.h"

namespace flexkey::cli {
namespace {

const Rgb blue = colour_from_srgb(33, 92, 214), red = colour_from_srgb(212, 43, 36),
          green = colour_from_srgb(22, 140, 60), clay = colour_from_srgb(204, 193, 180),
          tint = colour_from_srgb(240, 196, 110);

/// A green line in space: a path, or a curve that a chain of vertices is laid on.
struct GreenLine {
  Positions points;  // #points x 3
  Positions stops;   // of them or between them, where there are keys
};

std::vector<GreenLine> green_lines(const LoadedShot& loaded, const Scene& scene) {
  const std::vector<double> times = moments_to_look_at(loaded.shot);
  std::vector<GreenLine> lines;
  for (std::size_t h = 0; h < scene.handles.size(); ++h) {
    const Handle& handle = scene.handles[h].handle;
    const int number = static_cast<int>(h);
    if (handle.is_anchor()) continue;
    const std::vector<double> keys = key_times(handle);
    if (handle.curve.empty()) {
      lines.push_back({path_of(scene, number, times), path_of(scene, number, keys)});
      continue;
    }
    for (const double time : keys)
      lines.push_back({targets_of(scene, sample_states(scene, time), number), Positions(0, 3)});
  }
  return lines;
}

/// The mesh at rest and all lines: what the picture holds.
Positions outline_of(const Mesh& mesh, const std::vector<GreenLine>& lines) {
  Positions outline = mesh.positions;
  for (const GreenLine& line : lines) {
    outline.conservativeResize(outline.rows() + line.points.rows(), 3);
    outline.bottomRows(line.points.rows()) = line.points;
  }
  return outline;
}

/// A colour a vertex of the file: the region of interest tinted, where the shot names one.
std::vector<Rgb> colours_of(const LoadedShot& loaded, const Scene& scene) {
  if (!loaded.shot.roi) return {};
  std::vector<bool> is_inside(static_cast<std::size_t>(scene.weld.surface.vertex_count()), false);
  for (const int v : scene.constraints.region) is_inside[static_cast<std::size_t>(v)] = true;
  std::vector<Rgb> colours;
  for (const int v : scene.weld.to_surface)
    colours.push_back(is_inside[static_cast<std::size_t>(v)] ? tint : clay);
  return colours;
}

/// Where points are seen in a picture.
std::vector<Point> seen(const Positions& points, const Camera& camera, int height) {
  std::vector<Point> places;
  for (const auto& point : points.rowwise()) {
    const Vec3 place = project(camera, point.transpose(), height);
    places.push_back({place.x(), place.y()});
  }
  return places;
}

/// The vertex of a handle that is nearest to its middle, since the middle may lie inside.
Positions spot_of(const SceneHandle& handle) {
  const Eigen::RowVector3d middle = handle.rest.colwise().mean();
  Eigen::Index nearest = 0;
  (handle.rest.rowwise() - middle).rowwise().squaredNorm().minCoeff(&nearest);
  return handle.rest.row(nearest);
}

std::vector<Label> labels_of(const Scene& scene, const Camera& camera, int height) {
  std::vector<Label> labels;
  for (const SceneHandle& handle : scene.handles)
    labels.push_back({handle.handle.name, seen(spot_of(handle), camera, height).front(),
                      handle.handle.is_anchor() ? red : blue});
  return labels;
}

}  // namespace

void check_shot_picture(const LoadedShot& loaded, const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension.size() < 2)
    throw UsageError(fmt::format("--picture '{}' needs a name such as shot.png", path.string()));
  try {
    image_format(extension.substr(1));
  } catch (const InputError& error) {
    throw UsageError(fmt::format("--picture '{}': {}", path.string(), error.what()));
  }
  if (replaces_input(loaded, path))
    throw UsageError(fmt::format("--picture '{}' would replace an input", path.string()));
}

void write_shot_picture(const LoadedShot& loaded, const Scene& scene, const std::filesystem::path& path) {
  const Mesh& mesh = loaded.mesh;
  const std::vector<GreenLine> lines = green_lines(loaded, scene);
  const Positions outline = outline_of(mesh, lines);
  RenderOptions options = render_options(loaded);
  options.style = Style::clay;
  options.floor = bounds_of(mesh.positions).min.dot(up_vector(options.up));
  CameraSettings settings = camera_settings(loaded.shot.preview);
  settings.footer = 0;
  const Camera camera =
      fit_camera(settings, std::span(&outline, 1), static_cast<double>(options.width) / options.height);

  FrameState frame{mesh.positions};
  frame.colours = colours_of(loaded, scene);
  frame.marks = HandleMarks(scene, PreviewOutput::Handles::all).of_all();
  Picture picture = Renderer(mesh, bounds_of(outline), options).render(frame, camera);
  const double width = std::max(1.5, options.height / 250.0);
  for (const GreenLine& line : lines) {
    draw_line(picture, seen(line.points, camera, options.height), width, {green, 0.9f});
    for (const Point& stop : seen(line.stops, camera, options.height))
      draw_line(picture, std::span(&stop, 1), 3.5 * width, {green});
  }
  draw_labels(picture, labels_of(scene, camera, options.height));
  write_picture(picture, path);
}

}  // namespace flexkey::cli
