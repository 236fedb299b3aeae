#include "flexkey/gltf/asset.h"

#include <utility>

namespace flexkey {

Asset asset_of(const Clip& clip, const GltfOptions& options) {
  std::vector<Primitive> primitives = split_primitives(clip.mesh);
  TextureSet textures = read_textures(clip.mesh, primitives, options.texture_folder);
  std::optional<SeamlessNormals> normals;
  if (options.normals) normals.emplace(clip.mesh);
  Shape rest = shape_at(clip.mesh.positions, normals);
  return {clip, std::move(primitives), std::move(textures), std::move(normals), std::move(rest)};
}

}  // namespace flexkey
