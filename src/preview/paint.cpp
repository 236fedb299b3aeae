#include "flexkey/preview/paint.h"

#include <tbb/parallel_for.h>

namespace flexkey {
namespace {

const Rgb kClay = from_srgb({0.800f, 0.755f, 0.705f});
const Rgb kError = from_srgb({0.82f, 0.36f, 0.30f});

std::vector<Rgb> material_colours(const Mesh& mesh) {
  std::vector<Rgb> colours;
  for (const Material& material : mesh.materials)
    colours.push_back(from_srgb(material.base_color.cwiseMax(0).cwiseMin(1).cast<float>()));
  return colours;
}

}  // namespace

Paint paint_of(const Mesh& mesh, const RenderOptions& options, Solve solve) {
  Paint paint;
  paint.style = options.style;
  paint.base = kClay;
  paint.mesh = &mesh;
  paint.texture = &options.texture;
  if (options.style == Style::lambda) paint.base = lambda_colour(0.5f);
  if (options.style == Style::error && solve == Solve::unfinished) paint.base = kError;
  if (options.style == Style::textured && !mesh.face_material.empty())
    paint.of_material = material_colours(mesh);
  return paint;
}

std::vector<Rgb> displacement_colours(const Points& offsets, float top) {
  std::vector<Rgb> colours(static_cast<std::size_t>(offsets.rows()));
  tbb::parallel_for(Eigen::Index{0}, offsets.rows(), [&](Eigen::Index v) {
    colours[static_cast<std::size_t>(v)] = viridis(top > 0 ? offsets.row(v).norm() / top : 0.0f);
  });
  return colours;
}

std::vector<Rgb> lambda_colours(const Eigen::VectorXf& lambda) {
  std::vector<Rgb> colours;
  for (const float value : lambda) colours.push_back(lambda_colour(value));
  return colours;
}

}  // namespace flexkey
