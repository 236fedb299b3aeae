#include "flexkey/cache/usda.h"

#include <gmock/gmock.h>

#include "cache/frames.h"
#include "cache/usda_file.h"

namespace flexkey {
namespace {

using nlohmann::json;
using test::read_usda;
using test::UsdaFile;
using test::UsdaPrim;
using test::write_all;

class Usda : public test::Folder {
 protected:
  UsdaFile written(const CacheShape& shape) const {
    const std::uintmax_t bytes = write_all(usda_sink(*this / "a.usda", shape), shape);
    EXPECT_EQ(bytes, std::filesystem::file_size(*this / "a.usda"));
    return read_usda(read_file(*this / "a.usda"));
  }
};

const UsdaPrim& mesh_of(const UsdaFile& file) {
  return file.prims.at(0).children.at(0);
}

/// #rows x 3 doubles that are floats.
Eigen::Matrix<float, Eigen::Dynamic, 3> floats(const json& rows) {
  Eigen::Matrix<float, Eigen::Dynamic, 3> matrix(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      matrix(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(axis)) = rows[k].at(axis).get<float>();
  return matrix;
}

TEST_F(Usda, SaysWhenItPlaysAndWhereUpIs) {
  const Mesh mesh = meshes::cube();
  const UsdaFile file = written({"my shot", mesh, 29.97, {3, 4, 9}, {}});
  EXPECT_EQ(file.metadata, json({{"defaultPrim", "my_shot"},
                                 {"startTimeCode", 3.0},
                                 {"endTimeCode", 9.0},
                                 {"timeCodesPerSecond", 29.97},
                                 {"framesPerSecond", 29.97},
                                 {"metersPerUnit", 1.0},
                                 {"upAxis", "Y"}}));
  ASSERT_EQ(file.prims.size(), 1u);
  EXPECT_EQ(file.prims[0].type, "Xform");
  EXPECT_EQ(file.prims[0].name, "my_shot");
  ASSERT_EQ(file.prims[0].children.size(), 1u);
  EXPECT_EQ(mesh_of(file).type, "Mesh");
}

TEST_F(Usda, PrimNamesAreIdentifiers) {
  const Mesh mesh = meshes::cube();
  for (const auto& [name, prim] : std::map<std::string, std::string>{
           {"2nd", "_2nd"}, {"", "_"}, {"a-b.c", "a_b_c"}, {"\"x\"\n", "_x__"}, {"ä", "__"}})
    EXPECT_EQ(written({name, mesh, 24, {0}, {}}).prims.at(0).name, prim);
}

TEST_F(Usda, PolygonsStayAsTheyAreAndAreNotSubdivided) {
  const Mesh mesh = test::mixed_mesh();
  const auto attributes = mesh_of(written({"shot", mesh, 24, {0}, {}})).attributes;
  EXPECT_EQ(attributes.at("faceVertexCounts").type, "int[]");
  EXPECT_EQ(attributes.at("faceVertexCounts").value, json({4, 4, 4, 4, 4, 4, 3}));
  EXPECT_EQ(attributes.at("faceVertexIndices").value, json(mesh.corners));
  EXPECT_EQ(attributes.at("subdivisionScheme").type, "uniform token");
  EXPECT_EQ(attributes.at("subdivisionScheme").value, "none");
}

TEST_F(Usda, PointsHaveASampleAFrameAndRestAsTheirDefault) {
  const Mesh mesh = test::mixed_mesh();
  const auto attributes = mesh_of(written({"shot", mesh, 24, {0, 10, 11}, {}})).attributes;
  EXPECT_EQ(attributes.at("points").type, "point3f[]");
  EXPECT_EQ(floats(attributes.at("points").value), mesh.positions.cast<float>());
  const json& samples = attributes.at("points.timeSamples").value;
  ASSERT_EQ(samples.size(), 3u);
  for (const int k : {0, 10, 11})
    EXPECT_EQ(floats(samples.at(std::to_string(k))), test::posed(mesh, k).cast<float>());
}

TEST_F(Usda, ExtentsAreTheBoxesOfThePoints) {
  const Mesh mesh = test::mixed_mesh();
  const auto attributes = mesh_of(written({"shot", mesh, 24, {0, 10}, {}})).attributes;
  EXPECT_EQ(attributes.at("extent.timeSamples").type, "float3[]");
  const json& extents = attributes.at("extent.timeSamples").value;
  ASSERT_EQ(extents.size(), 2u);
  for (const int k : {0, 10}) {
    const Eigen::MatrixXf points = test::posed(mesh, k).cast<float>();
    const auto extent = floats(extents.at(std::to_string(k)));
    EXPECT_EQ(extent.row(0), points.colwise().minCoeff());
    EXPECT_EQ(extent.row(1), points.colwise().maxCoeff());
  }
}

TEST_F(Usda, TextureCoordinatesAreFaceVarying) {
  const Mesh mesh = test::mixed_mesh();
  const auto attributes = mesh_of(written({"shot", mesh, 24, {0}, {}})).attributes;
  const auto& st = attributes.at("primvars:st");
  EXPECT_EQ(st.type, "texCoord2f[]");
  EXPECT_EQ(st.metadata, json({{"interpolation", "faceVarying"}}));
  ASSERT_EQ(st.value.size(), 5u) << "those of the mesh and one for corners without";
  EXPECT_EQ(st.value[1].at(0).get<float>(), static_cast<float>(1.0 / 3));
  EXPECT_EQ(st.value[4], json({0.0, 0.0}));
  const json& indices = attributes.at("primvars:st:indices").value;
  ASSERT_EQ(indices.size(), mesh.corners.size());
  for (std::size_t c = 0; c < indices.size(); ++c)
    EXPECT_EQ(indices[c], mesh.corner_texcoord[c] < 0 ? 4 : mesh.corner_texcoord[c]);

  const Mesh plain = meshes::cube();
  EXPECT_FALSE(mesh_of(written({"shot", plain, 24, {0}, {}})).attributes.contains("primvars:st"));
}

}  // namespace
}  // namespace flexkey
