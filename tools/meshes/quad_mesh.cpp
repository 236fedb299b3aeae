#include "quad_mesh.h"

#include <algorithm>
#include <cmath>

namespace flexkey::meshes {

Index part_index(QuadMesh& mesh, const std::string& name) {
  auto& names = mesh.part_names;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<Index>(found - names.begin());
  names.push_back(name);
  return names.size() - 1;
}

Vec3 face_centre(const QuadMesh& mesh, Index face) {
  Vec3 sum = Vec3::Zero();
  for (Index v : mesh.faces[face]) sum += mesh.vertices[v];
  return sum / 4.0;
}

Vec3 face_area_vector(const QuadMesh& mesh, Index face) {
  const Quad& q = mesh.faces[face];
  const Vec3 d1 = mesh.vertices[q[2]] - mesh.vertices[q[0]];
  const Vec3 d2 = mesh.vertices[q[3]] - mesh.vertices[q[1]];
  return 0.5 * d1.cross(d2);
}

namespace {

std::string twin_name(const std::string& name) {
  const std::string left = "_left";
  const Index at = name.find(left);
  if (at == std::string::npos) return name;
  return name.substr(0, at) + "_right" + name.substr(at + left.size());
}

}  // namespace

QuadMesh mirrored(const QuadMesh& half) {
  QuadMesh full = half;
  const Index n = half.vertices.size();
  full.vertex_mirror.resize(n);
  for (Index v = 0; v < n; ++v) {
    Vec3 p = half.vertices[v];
    if (std::abs(p.x()) < 1e-9) {
      full.vertices[v].x() = 0.0;
      full.vertex_mirror[v] = v;
      continue;
    }
    p.x() = -p.x();
    full.vertex_mirror[v] = full.vertices.size();
    full.vertices.push_back(p);
    full.vertex_mirror.push_back(v);
  }
  const Index m = half.faces.size();
  for (Index f = 0; f < m; ++f) {
    const Quad& q = half.faces[f];
    const auto& map = full.vertex_mirror;
    full.faces.push_back({map[q[0]], map[q[3]], map[q[2]], map[q[1]]});
    full.parts.push_back(part_index(full, twin_name(half.part_names[half.parts[f]])));
  }
  full.face_mirror.resize(2 * m);
  for (Index f = 0; f < m; ++f) {
    full.face_mirror[f] = m + f;
    full.face_mirror[m + f] = f;
  }
  return full;
}

void symmetrise(QuadMesh& mesh) {
  for (Index v = 0; v < mesh.vertices.size(); ++v) {
    const Index w = mesh.vertex_mirror[v];
    Vec3& p = mesh.vertices[v];
    if (w == v) {
      p.x() = 0.0;
    } else if (v < w) {
      Vec3& q = mesh.vertices[w];
      p = 0.5 * (p + Vec3(-q.x(), q.y(), q.z()));
      q = Vec3(-p.x(), p.y(), p.z());
    }
  }
}

}  // namespace flexkey::meshes
