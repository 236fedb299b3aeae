#include "flexkey/preview/control_mesh.h"

#include <gmock/gmock.h>

#include "flexkey/preview/subdivision.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::string obstacle(const Mesh& mesh) {
  return subdivision_obstacle(control_mesh(mesh, 0));
}

TEST(ControlMesh, SeesNoObstacleInSoundMeshes) {
  EXPECT_THAT(obstacle(meshes::cube()), IsEmpty());
  EXPECT_THAT(obstacle(meshes::grid(2, 3)), IsEmpty());
  EXPECT_THAT(obstacle(meshes::sphere(1)), IsEmpty());
}

TEST(ControlMesh, NamesANonManifoldEdge) {
  const Mesh fins = meshes::make_mesh({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
                                      {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_THAT(obstacle(fins), HasSubstr("1 non-manifold edge (0-1)"));
}

TEST(ControlMesh, NamesABowtie) {
  const Mesh cones = meshes::make_mesh({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                                       {{1, 2, 3}, {1, 4, 5}});
  EXPECT_THAT(obstacle(cones),
              HasSubstr("1 vertex where surfaces touch in a point (1)"));  // the file's number
}

TEST(ControlMesh, NamesFlippedAndDuplicateFaces) {
  const Mesh flipped =
      meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 2}, {3, 0, 1}});
  EXPECT_THAT(obstacle(flipped), HasSubstr("flipped edge"));
  const Mesh twice = meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 2, 0}});
  EXPECT_THAT(obstacle(twice), HasSubstr("1 duplicate face (1)"));
}

TEST(ControlMesh, LosesWhatWeldingCollapses) {
  // A quad whose last two vertices lie at one place, a face at a line, and a vertex of no face.
  const Mesh pole =
      meshes::make_mesh({{5, 5, 5}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}}, {{1, 2, 3, 4}, {3, 4, 1}});
  const ControlMesh control = control_mesh(pole, 0);
  EXPECT_EQ(control.mesh.face_count(), 1);
  EXPECT_EQ(control.mesh.face(0).size(), 3u);
  EXPECT_THAT(control.vertex_source, testing::ElementsAre(1, 2, 3));
  EXPECT_THAT(control.of_vertex, testing::ElementsAre(-1, 0, 1, 2, 2));
  EXPECT_THAT(obstacle(pole), IsEmpty());
}

TEST(ControlMesh, AMeshWithAnObstacleIsDrawnAsItIs) {
  const Mesh cones =
      meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
  const Subdivision subdivision(cones, 2);
  EXPECT_EQ(subdivision.surface().triangles.size(), 2u);
  EXPECT_THAT(subdivision.warning(), HasSubstr("drawn without subdivision"));
  EXPECT_THAT(Subdivision(cones, 0).warning(), IsEmpty());
}

}  // namespace
}  // namespace flexkey
