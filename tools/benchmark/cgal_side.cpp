#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>

#include <memory>
#include <utility>

#include "flexkey/mesh/error.h"
#include "side.h"

namespace flexkey::bench {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Deformation =
    CGAL::Surface_mesh_deformation<Surface, CGAL::Default, CGAL::Default, CGAL::ORIGINAL_ARAP>;
using Vertex = Surface::Vertex_index;

struct State {
  Surface surface;
  std::vector<int> handles;
  unsigned iterations = 0;
  std::unique_ptr<Deformation> deformation = {};
};

Vertex vertex(int v) {
  return Vertex(static_cast<Surface::size_type>(v));
}

Surface surface_of(const Mesh& mesh) {
  Surface surface;
  for (const auto& p : mesh.positions.rowwise()) surface.add_vertex(Point(p.x(), p.y(), p.z()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    surface.add_face(vertex(face[0]), vertex(face[1]), vertex(face[2]));
  }
  return surface;
}

void set_up(State& state) {
  state.deformation = std::make_unique<Deformation>(state.surface);
  Deformation& deformation = *state.deformation;
  const auto vertices = state.surface.vertices();
  deformation.insert_roi_vertices(vertices.begin(), vertices.end());
  for (const int v : state.handles) deformation.insert_control_vertex(vertex(v));
  if (!deformation.preprocess()) throw Error("CGAL cannot factor the system");
}

SolveReport solve(State& state, const Positions& targets) {
  for (std::size_t h = 0; h < state.handles.size(); ++h) {
    const auto to = targets.row(static_cast<Eigen::Index>(h));
    state.deformation->set_target_position(vertex(state.handles[h]), Point(to.x(), to.y(), to.z()));
  }
  constexpr double no_early_end = 0;  // nor the cost of judging one
  state.deformation->deform(state.iterations, no_early_end);
  return {.solves = static_cast<int>(state.iterations)};
}

Positions positions(const Surface& surface) {
  Positions result(static_cast<Eigen::Index>(surface.number_of_vertices()), 3);
  for (const Vertex v : surface.vertices()) {
    const Point& p = surface.point(v);
    result.row(static_cast<Eigen::Index>(v.idx())) << p.x(), p.y(), p.z();
  }
  return result;
}

}  // namespace

Side cgal_side(const Mesh& mesh, const Constraints& constraints, int iterations) {
  const auto state = std::make_shared<State>(
      State{surface_of(mesh), constraints.handles, static_cast<unsigned>(iterations)});
  return {[state] { set_up(*state); },
          [state](const Targets& targets) { return solve(*state, targets.positions); },
          [state] { return positions(state->surface); }};
}

}  // namespace flexkey::bench
