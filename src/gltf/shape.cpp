#include "flexkey/gltf/shape.h"

namespace flexkey {

SeamlessNormals::SeamlessNormals(const Mesh& mesh) : weld_(weld(mesh)) {
  first_.assign(static_cast<std::size_t>(weld_.surface.vertex_count()), -1);
  for (std::size_t v = 0; v < weld_.to_surface.size(); ++v) {
    int& first = first_[static_cast<std::size_t>(weld_.to_surface[v])];
    if (first < 0) first = static_cast<int>(v);
  }
}

Positions SeamlessNormals::at(const Positions& positions) const {
  return scatter(weld_, vertex_normals(weld_.surface, positions(first_, Eigen::all)));
}

Shape shape_at(const Positions& positions, const std::optional<SeamlessNormals>& normals) {
  Shape shape{positions.cast<float>(), {}};
  if (normals) shape.normals = normals->at(positions).cast<float>();
  return shape;
}

}  // namespace flexkey
