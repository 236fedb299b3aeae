#include "flexkey/preview/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "flexkey/mesh/error.h"
#include "flexkey/preview/draft_pass.h"
#include "flexkey/preview/final_pass.h"
#include "flexkey/preview/normals.h"
#include "flexkey/preview/paint.h"
#include "flexkey/preview/subdivision.h"

namespace flexkey {
namespace {

const Rgb kHandle = from_srgb({0.13f, 0.36f, 0.84f});
const Rgb kTarget = from_srgb({0.16f, 0.66f, 0.29f});
const Rgb kAnchor = from_srgb({0.83f, 0.17f, 0.14f});
constexpr float kLargestDot = 0.0045f;  // shares of the diagonal
constexpr float kDotOfEdge = 0.3f;      // of the middle edge, so that dots of neighbours stay apart
constexpr float kWireOfPixel = 0.55f;   // radius of wires

Bounds checked(const Bounds& bounds) {
  if (!bounds.min.allFinite() || !bounds.max.allFinite())
    throw InputError("the bounds of the clip are not finite");
  return bounds;
}

/// Height of the ground in unit space.
float floor_in(const UnitSpace& space, const Bounds& bounds, const RenderOptions& options) {
  const Vec3 up = up_vector(options.up);
  const double height = options.floor.value_or(bounds.min.dot(up));
  return static_cast<float>((height - space.centre.dot(up)) * space.scale);
}

/// Half of the control mesh's edges are shorter.
float median_edge(const Surface& surface, const Points& points) {
  std::vector<float> lengths;
  for (const auto& [a, b, c] : surface.triangles) lengths.push_back((points.row(a) - points.row(b)).norm());
  if (lengths.empty()) return 1;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

}  // namespace

struct Renderer::Impl {
  const Mesh& mesh;
  RenderOptions options;
  UnitSpace space;
  float floor;
  Subdivision subdivision;
  Normals normals;
  std::optional<Tracer> tracer;  // for Quality::final
  Points rest;
  float dot_radius;
  std::vector<std::string> warnings;

  Impl(const Mesh& rest_mesh, const Bounds& bounds, RenderOptions chosen);
  Points refined(const Positions& positions) const;
  Eigen::VectorXf refined_lambda(const Eigen::VectorXf& lambda) const;
  std::vector<Rgb> refined_colours(const std::vector<Rgb>& colours) const;
  void check(const FrameState& frame) const;
  std::vector<Dot> dots(const Marks& marks, const Points& points) const;
  DrawnFrame draw(const FrameState& frame) const;
};

Renderer::Impl::Impl(const Mesh& rest_mesh, const Bounds& bounds, RenderOptions chosen)
    : mesh(rest_mesh),
      options((check_options(chosen), std::move(chosen))),
      space(checked(bounds)),
      floor(floor_in(space, bounds, options)),
      subdivision(mesh, options.subdivide, options.weld),
      normals(subdivision.surface()),
      rest(refined(mesh.positions)) {
  if (options.quality == Quality::final) tracer.emplace(subdivision.surface());
  const auto halvings = static_cast<float>(1 << (subdivision.warning().empty() ? options.subdivide : 0));
  dot_radius = std::min(kLargestDot, kDotOfEdge * halvings * median_edge(subdivision.surface(), rest));
  if (!subdivision.warning().empty()) warnings.push_back(subdivision.warning());
}

Points Renderer::Impl::refined(const Positions& positions) const {
  const std::vector<int>& vertices = subdivision.control_vertices();
  Points control(static_cast<Eigen::Index>(vertices.size()), 3);
  for (std::size_t k = 0; k < vertices.size(); ++k)
    control.row(static_cast<Eigen::Index>(k)) =
        space.place(positions.row(vertices[k]).transpose()).transpose();
  return subdivision.points(control);
}

Eigen::VectorXf Renderer::Impl::refined_lambda(const Eigen::VectorXf& lambda) const {
  const std::vector<int>& vertices = subdivision.control_vertices();
  Points control = Points::Zero(static_cast<Eigen::Index>(vertices.size()), 3);
  control.col(0) = lambda(vertices);
  return subdivision.points(control).col(0);
}

std::vector<Rgb> Renderer::Impl::refined_colours(const std::vector<Rgb>& colours) const {
  const std::vector<int>& vertices = subdivision.control_vertices();
  Points control(static_cast<Eigen::Index>(vertices.size()), 3);
  for (std::size_t k = 0; k < vertices.size(); ++k)
    control.row(static_cast<Eigen::Index>(k)) = colours[static_cast<std::size_t>(vertices[k])].transpose();
  const Points refined = subdivision.points(control);
  std::vector<Rgb> result;
  for (const auto& colour : refined.rowwise()) result.emplace_back(colour.transpose());
  return result;
}

void Renderer::Impl::check(const FrameState& frame) const {
  if (frame.positions.rows() != mesh.vertex_count())
    throw InputError(fmt::format("a frame of {} vertices does not fit a mesh of {}", frame.positions.rows(),
                                 mesh.vertex_count()));
  if (frame.lambda.size() != 0 && frame.lambda.size() != mesh.vertex_count())
    throw InputError(
        fmt::format("λ of {} vertices does not fit a mesh of {}", frame.lambda.size(), mesh.vertex_count()));
  if (!frame.colours.empty() && frame.colours.size() != static_cast<std::size_t>(mesh.vertex_count()))
    throw InputError(fmt::format("{} colours do not fit a mesh of {} vertices", frame.colours.size(),
                                 mesh.vertex_count()));
  for (Eigen::Index v = 0; v < frame.positions.rows(); ++v)
    if (!frame.positions.row(v).allFinite())
      throw InputError(fmt::format("vertex {} of the frame is not at a finite place", v));
  for (const auto* vertices : {&frame.marks.handles, &frame.marks.anchors})
    for (const int v : *vertices)
      if (v < 0 || v >= mesh.vertex_count())
        throw InputError(fmt::format("there is no vertex {} to mark", v));
}

std::vector<Dot> Renderer::Impl::dots(const Marks& marks, const Points& points) const {
  std::vector<Dot> dots;
  const auto add = [&](const std::vector<int>& vertices, const Rgb& colour) {
    for (const int v : vertices) {
      const int place = subdivision.surface().of_vertex[static_cast<std::size_t>(v)];
      if (place >= 0) dots.push_back({points.row(place).transpose(), dot_radius, colour});
    }
  };
  add(marks.anchors, kAnchor);
  add(marks.handles, kHandle);
  for (Eigen::Index k = 0; k < marks.targets.rows(); ++k)
    dots.push_back({space.place(marks.targets.row(k).transpose()), dot_radius, kTarget});
  return dots;
}

DrawnFrame Renderer::Impl::draw(const FrameState& frame) const {
  Points points = refined(frame.positions);
  Points directions = normals.at(points);
  Paint paint = paint_of(mesh, options, frame.converged ? Solve::converged : Solve::unfinished);
  if (options.style == Style::lambda && frame.lambda.size() > 0)
    paint.of_vertex = lambda_colours(refined_lambda(frame.lambda));
  if (options.style == Style::displacement) {
    const double rest_diagonal = bounds_of(mesh.positions).diagonal() * space.scale;
    const double top = options.displacement_top * rest_diagonal;
    paint.of_vertex = displacement_colours(points - rest, static_cast<float>(top));
  }
  if (!frame.colours.empty()) paint.of_vertex = refined_colours(frame.colours);
  std::vector<Dot> marked = dots(frame.marks, points);
  return {subdivision.surface(), std::move(points), std::move(directions), std::move(paint),
          std::move(marked)};
}

Renderer::Renderer(const Mesh& rest, const Bounds& bounds, RenderOptions options)
    : impl_(std::make_unique<Impl>(rest, bounds, std::move(options))) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const std::vector<std::string>& Renderer::warnings() const {
  return impl_->warnings;
}

Picture Renderer::render(const FrameState& frame, const Camera& camera) {
  const RenderOptions& options = impl_->options;
  impl_->check(frame);
  DrawnFrame drawn = impl_->draw(frame);
  const View view(camera, impl_->space, options.width, options.height);
  const Light light(view, up_vector(options.up).cast<float>(), impl_->floor);
  if (options.style == Style::wire) drawn.wire_radius = kWireOfPixel * view.step * view.origin.norm();
  const Studio studio{view, light, drawn};
  if (options.quality == Quality::draft) return draft_picture(studio);
  impl_->tracer->update(drawn);
  return trace_picture(studio, *impl_->tracer, options.samples);
}

}  // namespace flexkey
