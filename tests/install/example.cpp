// Reads a timeline, solves it and writes the GLB: the whole of flexkey as a library.
#include <flexkey/animate/animate.h>
#include <flexkey/gltf/write_glb.h>
#include <flexkey/mesh/read_mesh.h>
#include <flexkey/timeline/parse.h>

int main(int, char** arguments) {
  const std::string timeline = arguments[1], mesh_folder = arguments[2], glb = arguments[3];
  const flexkey::Shot shot = flexkey::parse_shot(flexkey::read_timeline(timeline), timeline).shot;
  const flexkey::Mesh mesh = flexkey::read_mesh(mesh_folder + "/" + shot.mesh.file).mesh;
  const flexkey::Clip clip = flexkey::animate(shot, mesh);
  flexkey::write_glb(clip, {}, glb);
}
