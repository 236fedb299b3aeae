// Real meshes: every OBJ in the folder that FLEXKEY_TEST_MESHES names, held at one end and bent at the other.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "flexkey/animate/animate.h"
#include "flexkey/mesh/read_mesh.h"
#include "flexkey/timeline/parse.h"

namespace flexkey {
namespace {

namespace fs = std::filesystem;

TEST(RealMeshes, BendToAFiniteAnswerThatMeetsTheHandles) {
  const char* folder = std::getenv("FLEXKEY_TEST_MESHES");
  if (folder == nullptr) GTEST_SKIP() << "FLEXKEY_TEST_MESHES names no folder";
  int meshes = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".obj") continue;
    ++meshes;
    const Mesh mesh = read_mesh(entry.path()).mesh;
    const Shot shot =
        parse_shot(
            "mesh: m.obj\nfps: 4\nhandles:\n"
            "  low: {select: {axis: y, below: 8%}}\n"
            "  high: {select: {axis: y, above: 92%}, rotate: {axis: x, keys: {0s: 0deg, 1s: 30deg}}}\n",
            "shot.yaml")
            .shot;
    const Scene scene = bind_shot(shot, mesh);
    const Clip clip = animate(shot, mesh, scene);
    EXPECT_EQ(clip.frames[0], mesh.positions) << entry.path();
    const Positions targets = sample_targets(scene, 1);
    for (std::size_t v = 0; v < scene.weld.to_surface.size(); ++v) {
      EXPECT_TRUE(clip.frames[4].row(static_cast<Eigen::Index>(v)).allFinite());
      const auto& handles = scene.constraints.handles;
      const auto led = std::find(handles.begin(), handles.end(), scene.weld.to_surface[v]);
      if (led != handles.end()) {
        EXPECT_EQ(clip.frames[4].row(static_cast<Eigen::Index>(v)), targets.row(led - handles.begin()))
            << entry.path();
      }
    }
  }
  EXPECT_GT(meshes, 0);
}

}  // namespace
}  // namespace flexkey
