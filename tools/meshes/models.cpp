#include "models.h"

#include "subdivide.h"

namespace flexkey::meshes {

void fit_cage(QuadMesh& half_cage, const Clay& clay, const WrapOptions& options) {
  QuadMesh full = mirrored(half_cage);
  wrap(full, clay, options);
  for (Index v = 0; v < half_cage.vertices.size(); ++v) half_cage.vertices[v] = full.vertices[v];
}

QuadMesh shaped(const QuadMesh& half_cage, const Clay& clay, const std::vector<WrapOptions>& levels) {
  QuadMesh mesh = mirrored(half_cage);
  for (const WrapOptions& level : levels) {
    mesh = subdivided(mesh);
    wrap(mesh, clay, level);
  }
  return mesh;
}

}  // namespace flexkey::meshes
