#include "flexkey/gltf/asset.h"

#include <algorithm>
#include <utility>

#include "flexkey/gltf/float_grid.h"

namespace flexkey {
namespace {

constexpr double kNormalStep = 1.0 / 256;      // turns a normal by an eighth of a degree on average
constexpr double kTexcoordStep = 1.0 / 16384;  // a quarter of a pixel of a large texture

/// The base on grids that pack well; positions are off by a small part of the tolerance.
Shape coarsened(const Shape& rest, double tolerance, double diagonal) {
  if (diagonal <= 0) return rest;
  const double step = power_of_two_below(std::min(0.05 * tolerance, 1.0 / 16384) * diagonal);
  return {on_grid(rest.positions, step), on_grid(rest.normals, kNormalStep)};
}

}  // namespace

NormalsAt normals_of(const Asset& asset) {
  if (!asset.normals) return {};
  return [&normals = *asset.normals](const Positions& positions) { return normals.at(positions); };
}

Asset asset_of(const Clip& clip, const GltfOptions& options) {
  std::vector<Primitive> primitives = split_primitives(clip.mesh);
  TextureSet textures = read_textures(clip.mesh, primitives, options.texture_folder);
  std::optional<SeamlessNormals> normals;
  if (options.normals) normals.emplace(clip.mesh);
  Shape rest = shape_at(clip.mesh.positions, normals);
  double texcoord_step = 0;
  if (options.encoding == Encoding::meshopt) {
    rest = coarsened(rest, options.tolerance, bounds_of(clip.mesh.positions).diagonal());
    texcoord_step = kTexcoordStep;
  }
  return {clip,         std::move(primitives), std::move(textures), std::move(normals), std::move(rest),
          texcoord_step};
}

}  // namespace flexkey
