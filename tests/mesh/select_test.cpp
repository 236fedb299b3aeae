#include "flexkey/mesh/select.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "support/meshes.h"

namespace flexkey {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A 4 x 4 grid of quads with groups and a material; vertex (i, j) is i + 5 j.
Mesh labelled_grid() {
  Mesh mesh = meshes::grid(4, 4);
  mesh.groups = {{"corner", {0}}, {"leg_hind_left", {5, 6}}};
  Material paint;
  paint.name = "paint";
  mesh.materials = {paint};
  mesh.face_material.assign(16, -1);
  mesh.face_material[15] = 0;
  return mesh;
}

/// Two triangles apart, whose last vertex has no value of '_MASK', and a copy of the first vertex that has.
Mesh masked_triangles() {
  Mesh mesh;
  mesh.positions.resize(7, 3);
  mesh.positions << 0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0, 0, 0, 0;
  mesh.add_face(std::vector<int>{0, 1, 2});
  mesh.add_face(std::vector<int>{3, 4, 5});
  const double none = std::numeric_limits<double>::quiet_NaN();
  mesh.attributes = {{"_MASK", Eigen::VectorXd(7)}};
  mesh.attributes[0].values << none, 0.5, 1, 1.5, 2, none, 0;
  return mesh;
}

class SelectTest : public testing::Test {
 protected:
  template <class Kind>
  std::vector<int> select(Kind kind, int grow = 0) const {
    return Selector(welded_, "grid.obj").select({std::move(kind), grow, {7, 3}});
  }
  template <class Kind>
  std::string error_of(Kind kind) const {
    try {
      select(std::move(kind));
    } catch (const SelectionError& error) {
      EXPECT_EQ(error.where().line, 7);
      return error.what();
    }
    return "no error";
  }
  static Selection of(auto kind) { return {std::move(kind), 0, {7, 3}}; }

  const Weld welded_ = weld(labelled_grid());
};

TEST_F(SelectTest, Attribute) {
  const Weld welded = weld(masked_triangles());
  const auto select = [&](std::optional<Length> above, std::optional<Length> below) {
    return Selector(welded, "pig.glb").select({SelectAttribute{"_MASK", above, below}, 0, {7, 3}});
  };
  const Length half{0.5, false}, most{0.75, true};
  EXPECT_THAT(select(half, {}), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(select({}, half), ElementsAre(0, 1)) << "0 by its copy, and 5 has no value";
  EXPECT_THAT(select(half, most), ElementsAre(1, 2, 3)) << "up to 75 % of 0..2";
  EXPECT_THROW(select(Length{3, false}, {}), SelectionError);
  EXPECT_EQ(error_of(SelectAttribute{"_MASK", half, {}}),
            "no attribute '_MASK' in grid.obj; it has no attributes");
}

TEST_F(SelectTest, Vertices) {
  EXPECT_THAT(select(SelectVertices{{{8, 10}, {0, 0}, {9, 9}}}), ElementsAre(0, 8, 9, 10));
  EXPECT_EQ(error_of(SelectVertices{{{20, 25}}}),
            "vertices 20-25 are not all among the 25 of grid.obj, 0 to 24");
}

TEST_F(SelectTest, GroupsAndMaterials) {
  EXPECT_THAT(select(SelectGroup{"corner"}), ElementsAre(0, 1, 5, 6));
  EXPECT_THAT(select(SelectMaterial{"paint"}), ElementsAre(18, 19, 23, 24));
  EXPECT_EQ(error_of(SelectGroup{"leg_hind_l"}),
            "no group 'leg_hind_l' in grid.obj; did you mean 'leg_hind_left'?");
  EXPECT_EQ(error_of(SelectGroup{"zzz"}), "no group 'zzz' in grid.obj; it has corner, leg_hind_left");
  EXPECT_THAT(error_of(SelectMaterial{"pant"}), HasSubstr("did you mean 'paint'?"));
  EXPECT_THAT(select(SelectNode{"corner"}), ElementsAre(0, 1, 5, 6));
  EXPECT_EQ(error_of(SelectNode{"cornre"}), "no node 'cornre' in grid.obj; did you mean 'corner'?");
}

TEST_F(SelectTest, Solids) {
  EXPECT_THAT(select(SelectSphere{{0, 0, 0}, {1, false}}), ElementsAre(0, 1, 5));
  EXPECT_THAT(select(SelectBox{{3, 3, -1}, {9, 9, 1}}), ElementsAre(18, 19, 23, 24));
  EXPECT_THAT(select(SelectPlane{{2, 0, 0}, {3, 0, 0}, {0, false}}), ElementsAre(2, 7, 12, 17, 22));
  EXPECT_THAT(select(SelectNearest{{3.9, 0.2, 5}}), ElementsAre(4));
}

TEST_F(SelectTest, SharesAreOfTheDiagonalAndOfTheExtent) {
  const double diagonal = std::sqrt(32.0);
  EXPECT_EQ(select(SelectSphere{{0, 0, 0}, {1.0 / diagonal, true}}).size(), 3u);
  EXPECT_THAT(select(SelectAxis{0, Length{0.99, true}, {}}), ElementsAre(4, 9, 14, 19, 24));
  EXPECT_THAT(select(SelectAxis{1, {}, Length{0, true}}), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(select(SelectAxis{1, Length{0.5, true}, Length{2.4, false}}), ElementsAre(10, 11, 12, 13, 14));
}

TEST_F(SelectTest, TheNearestMissIsNamed) {
  EXPECT_EQ(error_of(SelectSphere{{-3, 0, 0}, {1, false}}),
            "the selection takes no vertex; the nearest, vertex 0 at [0, 0, 0], misses it by 2");
  EXPECT_THAT(error_of(SelectAxis{2, Length{0.5, false}, {}}), HasSubstr("misses it by 0.5"));
  EXPECT_THAT(error_of(SelectBox{{0.2, 0.2, 0}, {0.8, 0.8, 0}}), HasSubstr("misses it by 0.2"));
}

TEST_F(SelectTest, AlongTheSurface) {
  EXPECT_THAT(select(SelectGeodesic{{0, 0, 0}, {1.2, false}}), ElementsAre(0, 1, 5));
  EXPECT_THAT(select(SelectPath{{{4, 0, 0}, {0, 0, 0}, {0, 2, 0}}}), ElementsAre(4, 3, 2, 1, 0, 5, 10));
}

TEST_F(SelectTest, BoundaryAndComponent) {
  EXPECT_EQ(select(SelectBoundary{}).size(), 16u);
  EXPECT_EQ(select(SelectComponent{0}).size(), 25u);
  EXPECT_EQ(error_of(SelectComponent{1}), "no component 1: grid.obj has 1, counted from 0");
  EXPECT_THAT(error_of(SelectComponent{-1}), HasSubstr("no component -1"));
}

TEST_F(SelectTest, Combinations) {
  const Selection left = of(SelectAxis{0, {}, Length{0, false}}),
                  bottom = of(SelectAxis{1, {}, Length{0, false}});
  EXPECT_EQ(select(SelectAny{{left, bottom}}).size(), 9u);
  EXPECT_THAT(select(SelectAll{{left, bottom}}), ElementsAre(0));
  EXPECT_EQ(select(SelectNot{{left}}).size(), 20u);
  EXPECT_EQ(error_of(SelectAll{{left, of(SelectNot{{left}})}}), "no vertex is in all parts of the selection");
  EXPECT_EQ(error_of(SelectNot{{of(SelectComponent{0})}}), "the selection excludes every vertex");
}

TEST_F(SelectTest, GrowAddsRingsLast) {
  EXPECT_THAT(select(SelectNearest{{0, 0, 0}}, 1), ElementsAre(0, 1, 5));
  EXPECT_EQ(select(SelectNearest{{0, 0, 0}}, 1000).size(), 25u);
}

TEST(Select, FileIndicesStandForTheirPlaceOnTheSurface) {
  const Mesh mesh = meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}},
                                      {{0, 1, 2}, {3, 4, 5}});
  const Weld welded = weld(mesh);
  const Selector selector(welded, "seam.obj");
  EXPECT_EQ(selector.select({SelectVertices{{{1, 1}}}, 0, {}}),
            selector.select({SelectVertices{{{3, 3}}}, 0, {}}));
  EXPECT_EQ(welded.surface.vertex_count(), 5);
}

TEST(Select, AClosedMeshHasNoBoundary) {
  const Mesh mesh = meshes::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  const Weld welded = weld(mesh);
  EXPECT_THROW(Selector(welded, "tetra.obj").select({SelectBoundary{}, 0, {}}), SelectionError);
}

}  // namespace
}  // namespace flexkey
