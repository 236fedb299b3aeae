#include "cli/picture_maker.h"

#include <fmt/format.h>

#include <numbers>

#include "cli/preview_settings.h"
#include "flexkey/animate/lambda_field.h"
#include "flexkey/mesh/read_file.h"
#include "flexkey/preview/images/draw_legend.h"
#include "flexkey/preview/images/textures.h"
#include "flexkey/preview/legend.h"
#include "flexkey/timeline/steps.h"

namespace flexkey::cli {
namespace {

/// The bytes of an array of numbers.
template <class Numbers>
std::string bytes_of(const Numbers& numbers) {
  const auto bytes = std::as_bytes(std::span(numbers.data(), static_cast<std::size_t>(numbers.size())));
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The height of the ground: the mesh at rest stands on it, unless it sinks far below.
double floor_of(const Positions& rest, const Framing& framing, Up up) {
  constexpr double far = 0.05;  // a share of the diagonal
  const Bounds standing = bounds_of(rest);
  const double low = standing.min.dot(up_vector(up)),
               lowest = bounds_of(framing.outline).min.dot(up_vector(up));
  return low - lowest < far * standing.diagonal() ? low : lowest;
}

/// The options for all pictures, and what has gone wrong on the way to them.
RenderOptions full_options(const LoadedShot& loaded, const Framing& framing,
                           std::vector<std::string>& warnings) {
  RenderOptions options = render_options(loaded);
  const double diagonal = bounds_of(loaded.mesh.positions).diagonal();
  options.displacement_top = displacement_top(framing.largest_offset, diagonal);
  options.floor = floor_of(loaded.mesh.positions, framing, options.up);
  if (options.style != Style::textured) return options;
  Textures textures = load_textures(loaded.mesh, loaded.mesh_path.parent_path());
  options.texture = std::move(textures.lookup);
  for (const std::string& warning : textures.warnings)
    warnings.push_back(fmt::format("warning: {}; its material is drawn in its colour", warning));
  return options;
}

Camera camera_for(const PreviewOutput& preview, const Framing& framing) {
  const double aspect = static_cast<double>(preview.width) / preview.height;
  return fit_camera(camera_settings(preview), std::span(&framing.outline, 1), aspect,
                    preview.turntable != 0 ? Turning::yes : Turning::no);
}

std::string camera_text(const Camera& camera) {
  std::string text = fmt::format("{} {}", camera.tan_half, camera.aspect);
  for (const Vec3& v : {camera.position, camera.right, camera.up, camera.forward})
    text += fmt::format(" {} {} {}", v.x(), v.y(), v.z());
  return text;
}

/// What the file of the base colours says, where they are drawn.
std::string texture_bytes(const Material& material, const LoadedShot& loaded) {
  if (loaded.shot.preview.style != PreviewOutput::Style::textured || material.texture.empty()) return {};
  try {
    return read_file(loaded.mesh_path.parent_path() / material.texture);
  } catch (const InputError&) {
    return "missing";  // there is a warning of it
  }
}

std::string hash_of_always(const LoadedShot& loaded, const RenderOptions& options, const Bounds& bounds) {
  const Mesh& mesh = loaded.mesh;
  std::vector<std::string> parts{
      FLEXKEY_VERSION,
      fmt::format("{} {} {} {} {} {} {} {} {} {}", options.width, options.height, options.samples,
                  options.subdivide, static_cast<int>(options.style), static_cast<int>(options.quality),
                  static_cast<int>(options.up), options.weld, options.displacement_top,
                  options.floor.value_or(0)),
      fmt::format("{}", loaded.shot.preview.overlay),
      bytes_of(bounds.min),
      bytes_of(bounds.max),
      bytes_of(mesh.positions),
      bytes_of(mesh.face_offsets),
      bytes_of(mesh.corners),
      bytes_of(mesh.texcoords),
      bytes_of(mesh.corner_texcoord),
      bytes_of(mesh.face_material)};
  for (const Crease& crease : mesh.creases)
    parts.push_back(fmt::format("crease {} {} {}", crease.from, crease.to, crease.sharpness));
  for (const SharpVertex& sharp : mesh.sharp_vertices)
    parts.push_back(fmt::format("sharp {} {}", sharp.vertex, sharp.sharpness));
  for (const Material& material : mesh.materials) {
    parts.push_back(bytes_of(material.base_color));
    parts.push_back(texture_bytes(material, loaded));
  }
  return hash_of(parts);
}

}  // namespace

PictureMaker::PictureMaker(const LoadedShot& loaded, const Scene& scene, const Framing& framing)
    : loaded_(loaded),
      scene_(scene),
      marks_(scene, loaded.shot.preview.handles),
      options_(full_options(loaded, framing, warnings_)),
      camera_(camera_for(loaded.shot.preview, framing)),
      renderer_(loaded.mesh, bounds_of(framing.outline), options_),
      always_(hash_of_always(loaded, options_, bounds_of(framing.outline))) {
  for (const std::string& warning : renderer_.warnings())
    warnings_.push_back(fmt::format("warning: {}: {}", loaded.mesh_path.string(), warning));
}

Camera PictureMaker::camera_at(int frame) const {
  const double share = static_cast<double>(frame) / loaded_.shot.frame_count();
  const double turns = loaded_.shot.preview.turntable;
  return turns == 0 ? camera_ : turned(camera_, 2 * std::numbers::pi * turns * share, options_.up);
}

Marks PictureMaker::marks_of(const KeptFrame& frame) const {
  return marks_.at(time_of_frame(loaded_.shot, frame.report.frame), frame.positions);
}

/// Where λ is what the colours say.
Eigen::VectorXf PictureMaker::lambda_of(const KeptFrame& frame, const PictureRun& of) const {
  if (options_.style != Style::lambda) return {};
  const Eigen::VectorXd lambda = lambda_at(of.shot, scene_, time_of_frame(of.shot, frame.report.frame));
  return lambda(scene_.weld.to_surface).cast<float>();
}

Picture PictureMaker::draw(const KeptFrame& frame, const PictureRun& of) {
  const FrameReport& report = frame.report;
  Picture picture = renderer_.render(
      {frame.positions, lambda_of(frame, of), report.converged, marks_of(frame)}, camera_at(report.frame));
  if (const std::optional<Legend> legend = legend_of(options_)) draw_legend(picture, *legend);
  if (loaded_.shot.preview.overlay)
    draw_overlay(picture, of.moments, of.moments[static_cast<std::size_t>(report.frame)]);
  return picture;
}

std::string PictureMaker::inputs(const KeptFrame& frame, const PictureRun& of) const {
  const FrameReport& report = frame.report;
  const Marks marks = marks_of(frame);
  std::vector<std::string> parts{always_,
                                 camera_text(camera_at(report.frame)),
                                 bytes_of(frame.positions),
                                 bytes_of(lambda_of(frame, of)),
                                 bytes_of(marks.handles),
                                 bytes_of(marks.anchors),
                                 bytes_of(marks.targets)};
  if (options_.style == Style::error) parts.push_back(fmt::format("{}", report.converged));
  if (loaded_.shot.preview.overlay) {
    parts.push_back(fmt::format("{} {}", report.frame, loaded_.shot.fps));
    for (const Moment& moment : of.moments) parts.push_back(fmt::format("{}", moment.lambda));
  }
  return hash_of(parts);
}

}  // namespace flexkey::cli
