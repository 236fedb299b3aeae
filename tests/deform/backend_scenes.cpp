// Solves some scenes and writes every frame's positions as they lie in memory: backend_scenes FILE. Built
// with each of the backends that factor, for backends_test.
#include <fstream>

#include "flexkey/deform/deformer.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

/// A bar held at one end, turned and pulled at the other over some frames.
void solve_scene(const DeformOptions& options, double lambda, std::ostream& out) {
  const Mesh mesh = meshes::bumpy(meshes::bar(4, 4, 16), 0.1);
  std::vector<int> handles = meshes::between(mesh, 2, -1, 0.5);
  const std::vector<int> top = meshes::between(mesh, 2, 15.5, 17);
  handles.insert(handles.end(), top.begin(), top.end());
  const Deformer deformer(mesh, {handles, {}}, options);
  Pose pose = deformer.rest_pose();
  const auto first_of_top = static_cast<Eigen::Index>(handles.size() - top.size());
  for (int frame = 1; frame <= 6; ++frame) {
    Positions targets = mesh.positions(handles, Eigen::all);
    targets.bottomRows(targets.rows() - first_of_top) =
        meshes::moved(targets.bottomRows(targets.rows() - first_of_top), meshes::turn(10 * frame, {1, 0, 1}),
                      {0, 0.3 * frame, 0});
    deformer.solve(targets, lambda, pose);
    out.write(reinterpret_cast<const char*>(pose.positions.data()),
              static_cast<std::streamsize>(sizeof(double)) * pose.positions.size());
  }
}

}  // namespace
}  // namespace flexkey

int main(int count, char** arguments) {
  if (count != 2) return 2;
  std::ofstream out(arguments[1], std::ios::binary);
  for (const flexkey::System system : {flexkey::System::least_squares, flexkey::System::direct})
    for (const double lambda : {0.0, 0.5, 0.8}) flexkey::solve_scene({.system = system}, lambda, out);
  return out.flush() ? 0 : 1;
}
