#include "wrap.h"

#include <algorithm>
#include <cmath>

namespace flexkey::meshes {

namespace {

// Where relaxing wants each vertex: the mean over its quads of their centre and of the corner of
// the square that fits the quad best.
std::vector<Vec3> relaxed_places(const QuadMesh& mesh, double square) {
  const Index n = mesh.vertices.size();
  std::vector<Vec3> sum(n, Vec3::Zero());
  std::vector<double> count(n, 0.0);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Quad& q = mesh.faces[f];
    const Vec3 centre = face_centre(mesh, f);
    const Vec3 normal = face_area_vector(mesh, f).normalized();
    std::array<Vec3, 4> arm;
    for (Index i = 0; i < 4; ++i) {
      const Vec3 d = mesh.vertices[q[i]] - centre;
      arm[i] = d - normal * normal.dot(d);
    }
    // Turning the arms back by their quarter turns lays them over each other; their mean is
    // the arm of the best square.
    const Vec3 mean = 0.25 * (arm[0] - normal.cross(arm[1]) - arm[2] + normal.cross(arm[3]));
    const Vec3 turned = normal.cross(mean);
    const std::array<Vec3, 4> corner{mean, turned, -mean, -turned};
    for (Index i = 0; i < 4; ++i) {
      sum[q[i]] += centre + square * corner[i];
      count[q[i]] += 1.0;
    }
  }
  for (Index v = 0; v < n; ++v) sum[v] /= count[v];
  return sum;
}

std::vector<Vec3> vertex_normals(const QuadMesh& mesh) {
  std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Vec3 normal = face_area_vector(mesh, f).normalized();
    for (Index v : mesh.faces[f]) normals[v] += normal;
  }
  for (Vec3& n : normals) n.normalize();
  return normals;
}

// One step onto the surface, half along the clay's gradient and half along the mesh normal: the
// gradient alone would crowd vertices into hollows and fold the mesh at thin parts.
Vec3 towards_surface(const Vec3& p, const Vec3& normal, const Clay& clay, double max_step) {
  const Vec3 g = clay.gradient(p);
  const Vec3 up = g.normalized();
  const Vec3 along = up.dot(normal) > -0.5 ? (up + normal).normalized() : normal;
  const double slope = std::max(g.dot(along), 0.3);
  return p - std::clamp(clay.value(p) / slope, -max_step, max_step) * along;
}

}  // namespace

void project(QuadMesh& mesh, const Clay& clay, int rounds, double max_step) {
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Vec3> normals = vertex_normals(mesh);
    for (Index v = 0; v < mesh.vertices.size(); ++v)
      mesh.vertices[v] = towards_surface(mesh.vertices[v], normals[v], clay, max_step);
  }
  symmetrise(mesh);
}

void wrap(QuadMesh& mesh, const Clay& clay, const WrapOptions& options) {
  project(mesh, clay, 3, options.max_step);
  const std::vector<Vec3> start = mesh.vertices;
  for (int round = 0; round < options.rounds; ++round) {
    const std::vector<Vec3> places = relaxed_places(mesh, options.square);
    const std::vector<Vec3> normals = vertex_normals(mesh);
    for (Index v = 0; v < mesh.vertices.size(); ++v) {
      Vec3& p = mesh.vertices[v];
      const Vec3& normal = normals[v];
      Vec3 move = (1.0 - options.hold) * (places[v] - p) + options.hold * (start[v] - p);
      move -= normal * normal.dot(move);
      p = towards_surface(p + options.relax * move, normal, clay, options.max_step);
    }
    symmetrise(mesh);
  }
  project(mesh, clay, 4, options.max_step);
}

}  // namespace flexkey::meshes
