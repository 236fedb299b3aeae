#include "flexkey/preview/subdivision.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <numeric>

#include "flexkey/mesh/connectivity.h"
#include "flexkey/mesh/error.h"
#include "flexkey/preview/control_mesh.h"
#include "flexkey/preview/refine.h"
#include "flexkey/preview/triangulate.h"

namespace flexkey {
namespace {

constexpr int kHighestLevel = 4;
constexpr double kMostTriangles = 50e6;  // 10 GB of stencils and trees

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// Triangles after `level` steps: a polygon of n corners gives n quads at the first, then four a quad.
double refined_triangles(const Mesh& mesh, int level) {
  if (level == 0) return static_cast<double>(mesh.corners.size()) - 2.0 * mesh.face_count();
  const bool is_loop = mesh.corners.size() == 3 * index(mesh.face_count());
  return is_loop ? mesh.face_count() * std::pow(4.0, level)
                 : 2.0 * static_cast<double>(mesh.corners.size()) * std::pow(4.0, level - 1);
}

void check_level(const Mesh& mesh, int level) {
  if (level < 0 || level > kHighestLevel)
    throw InputError(fmt::format("subdivision level {} is outside 0..{}", level, kHighestLevel));
  const double triangles = refined_triangles(mesh, level);
  if (triangles > kMostTriangles)
    throw InputError(fmt::format(
        "at subdivision level {} the mesh has {:.0f} million triangles, and at most {:.0f} million are drawn",
        level, triangles / 1e6, kMostTriangles / 1e6));
}

/// Each control vertex as it is.
Stencils identity(int vertices) {
  Stencils stencils;
  stencils.offsets.resize(index(vertices) + 1);
  std::iota(stencils.offsets.begin(), stencils.offsets.end(), 0);
  stencils.vertices.assign(stencils.offsets.begin(), stencils.offsets.end() - 1);
  stencils.weights.assign(index(vertices), 1.0f);
  return stencils;
}

Eigen::Vector2f texcoord(const Mesh& source, int corner) {
  const int row = source.corner_texcoord[index(corner)];
  return row < 0 ? Eigen::Vector2f(0, 0)
                 : Eigen::Vector2f(source.texcoords.row(row).transpose().cast<float>());
}

/// The polygons as they are, in triangles.
Surface unsubdivided(const ControlMesh& control, const Mesh& source) {
  const Mesh& mesh = control.mesh;
  Surface surface;
  surface.vertex_count = mesh.vertex_count();
  surface.of_vertex = control.of_vertex;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    const int first = mesh.face_offsets[index(f)];
    for (const auto& [a, b, c] : fan_of(face, mesh.positions)) {
      surface.triangles.push_back({face[index(a)], face[index(b)], face[index(c)]});
      surface.face_of.push_back(control.face_source[index(f)]);
      if (source.corner_texcoord.empty()) continue;
      const auto uv = [&](int k) { return texcoord(source, control.corner_source[index(first + k)]); };
      surface.texcoords.push_back({uv(a), uv(b), uv(c)});
    }
  }
  for (const MeshEdge& edge : mesh_edges(mesh)) surface.wires.push_back({edge.low, edge.high});
  return surface;
}

}  // namespace

Points apply(const Stencils& stencils, const Points& control) {
  // Four floats a point, so that a weight is one multiplication of a vector register.
  using Quad = Eigen::Array4f;
  Eigen::Matrix<float, Eigen::Dynamic, 4, Eigen::RowMajor> padded(control.rows(), 4);
  padded.setZero();
  padded.leftCols<3>() = control;
  const float* points = padded.data();
  Points refined(static_cast<Eigen::Index>(stencils.offsets.size()) - 1, 3);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, stencils.offsets.size() - 1, 4096),
                    [&](const auto& range) {
                      for (std::size_t v = range.begin(); v < range.end(); ++v) {
                        Quad sum = Quad::Zero();
                        for (auto k = index(stencils.offsets[v]); k < index(stencils.offsets[v + 1]); ++k)
                          sum += stencils.weights[k] *
                                 Eigen::Map<const Quad, Eigen::Aligned16>(points + 4 * stencils.vertices[k]);
                        refined.row(static_cast<Eigen::Index>(v)) = sum.head<3>().matrix().transpose();
                      }
                    });
  return refined;
}

Subdivision::Subdivision(const Mesh& mesh, int level, double weld) {
  ControlMesh control = control_mesh(mesh, weld);
  check_level(control.mesh, level);
  const std::string obstacle = level > 0 ? subdivision_obstacle(control) : "";
  if (!obstacle.empty())
    warning_ = fmt::format("drawn without subdivision, because the mesh has {}", obstacle);
  if (level == 0 || !obstacle.empty() || control.mesh.face_count() == 0) {
    stencils_ = identity(control.mesh.vertex_count());
    surface_ = unsubdivided(control, mesh);
  } else {
    Refined refined = refine(control, mesh, level);
    stencils_ = std::move(refined.stencils);
    surface_ = std::move(refined.surface);
  }
  control_vertices_ = std::move(control.vertex_source);
}

}  // namespace flexkey
