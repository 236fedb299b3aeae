#include "flexkey/gltf/materials.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "flexkey/gltf/write_glb.h"
#include "gltf/clips.h"
#include "gltf/glb_file.h"
#include "gltf/images.h"

namespace flexkey::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A sheet whose left half is of one material and the right half of the other, with texture coordinates.
Mesh two_halves(const Material& left, const Material& right) {
  Mesh mesh = sheet(4);
  unwrap_flat(mesh);
  mesh.materials = {left, right};
  for (int f = 0; f < mesh.face_count(); ++f) mesh.face_material.push_back(f % 4 < 2 ? 0 : 1);
  return mesh;
}

Material textured(const std::string& name, const std::string& texture) {
  Material result = material(name);
  result.texture = texture;
  return result;
}

class Materials : public ::testing::Test {
 protected:
  void save(const Mesh& mesh) {
    GltfOptions options = exact();
    options.texture_folder = folder_.path();
    report_ = write_glb(clip_of(mesh, 3, bump), options, folder_ / "shot.glb");
    model_ = load_glb(folder_ / "shot.glb");
  }

  /// The embedded file of a material's texture.
  std::string image_of(std::size_t material) const {
    const int texture = model_.materials.at(material).pbrMetallicRoughness.baseColorTexture.index;
    const int image = model_.textures.at(static_cast<std::size_t>(texture)).source;
    const int view_index = model_.images.at(static_cast<std::size_t>(image)).bufferView;
    const tinygltf::BufferView& view = model_.bufferViews.at(static_cast<std::size_t>(view_index));
    const auto* first = reinterpret_cast<const char*>(model_.buffers[0].data.data()) + view.byteOffset;
    return {first, view.byteLength};
  }

  TemporaryFolder folder_;
  GltfReport report_;
  tinygltf::Model model_;
};

TEST(LinearFromSrgb, FollowsTheStandardsCurve) {
  EXPECT_EQ(linear_from_srgb(0), 0);
  EXPECT_EQ(linear_from_srgb(1), 1);
  EXPECT_NEAR(linear_from_srgb(0.5), 0.21404114, 1e-8);
  EXPECT_NEAR(linear_from_srgb(0.04), 0.04 / 12.92, 1e-12);
  EXPECT_EQ(linear_from_srgb(-1), 0);
  EXPECT_EQ(linear_from_srgb(7), 1);
  EXPECT_EQ(linear_from_srgb(std::nan("")), 0);
}

TEST_F(Materials, KeepNameColourAndOpacity) {
  Material glass = material("glass");
  glass.base_color = {0.5, 1, 0};
  glass.opacity = 0.25;
  save(two_halves(material("skin"), glass));
  ASSERT_EQ(model_.materials.size(), 2u);
  EXPECT_EQ(model_.materials[0].name, "skin");
  EXPECT_EQ(model_.materials[0].alphaMode, "OPAQUE");
  EXPECT_EQ(model_.materials[1].name, "glass");
  EXPECT_EQ(model_.materials[1].alphaMode, "BLEND");
  const auto& pbr = model_.materials[1].pbrMetallicRoughness;
  EXPECT_THAT(pbr.baseColorFactor, ElementsAre(::testing::DoubleNear(0.21404114, 1e-8), 1, 0, 0.25));
  EXPECT_EQ(pbr.metallicFactor, 0);
  EXPECT_EQ(pbr.roughnessFactor, 0.8);
  EXPECT_THAT(report_.warnings, IsEmpty());
}

TEST_F(Materials, MakeAPrimitiveEachWithTheSameTargets) {
  save(two_halves(material("left"), material("right")));
  ASSERT_EQ(model_.meshes.size(), 1u);
  ASSERT_EQ(model_.meshes[0].primitives.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(model_.meshes[0].primitives[i].material, static_cast<int>(i));
    EXPECT_EQ(model_.meshes[0].primitives[i].targets.size(), 3u);
  }
  EXPECT_EQ(report_.targets, 3);
  EXPECT_EQ(report_.vertices, 15 + 15);  // the seam's five vertices are in both
}

TEST_F(Materials, FacesWithoutOneAreGrey) {
  save(sheet(2));
  ASSERT_EQ(model_.materials.size(), 1u);
  EXPECT_EQ(model_.materials[0].name, "default");
  EXPECT_EQ(model_.materials[0].pbrMetallicRoughness.metallicFactor, 0);
  EXPECT_NEAR(model_.materials[0].pbrMetallicRoughness.baseColorFactor[0], linear_from_srgb(0.8), 1e-12);
}

TEST_F(Materials, EmbedTheirTexturesByteForByte) {
  std::filesystem::create_directory(folder_ / "maps");
  std::ofstream(folder_ / "maps/skin.png", std::ios::binary) << red_png();
  std::ofstream(folder_ / "glass.jpg", std::ios::binary) << grey_jpeg();
  save(two_halves(textured("skin", "maps\\skin.png"), textured("glass", "glass.jpg")));
  EXPECT_THAT(report_.warnings, IsEmpty());
  ASSERT_EQ(model_.images.size(), 2u);
  EXPECT_EQ(model_.images[0].mimeType, "image/png");
  EXPECT_EQ(model_.images[0].name, "skin");
  EXPECT_EQ(model_.images[1].mimeType, "image/jpeg");
  EXPECT_EQ(image_of(0), red_png());
  EXPECT_EQ(image_of(1), grey_jpeg());
}

TEST_F(Materials, ShareATexture) {
  std::ofstream(folder_ / "skin.png", std::ios::binary) << red_png();
  save(two_halves(textured("left", "skin.png"), textured("right", "skin.png")));
  EXPECT_EQ(model_.images.size(), 1u);
  EXPECT_EQ(image_of(0), image_of(1));
}

TEST_F(Materials, WarnOfTexturesThatAreMissingOrNoImage) {
  std::ofstream(folder_ / "notes.png") << "not a picture";
  save(two_halves(textured("left", "nowhere.png"), textured("right", "notes.png")));
  EXPECT_THAT(report_.warnings,
              ElementsAre(HasSubstr("nowhere.png' of material 'left' is left out: there is no such"),
                          HasSubstr("notes.png' of material 'right' is left out: it is neither PNG")));
  EXPECT_THAT(model_.images, IsEmpty());
  EXPECT_EQ(model_.materials[0].pbrMetallicRoughness.baseColorTexture.index, -1);
}

TEST_F(Materials, WarnOfATextureThatIsAFolderOrADevice) {
  save(two_halves(textured("left", "."), textured("right", "/dev/zero")));
  EXPECT_EQ(report_.warnings.size(), 2u);
}

TEST_F(Materials, WarnOfATextureWithoutCoordinates) {
  std::ofstream(folder_ / "skin.png", std::ios::binary) << red_png();
  Mesh mesh = two_halves(textured("left", "skin.png"), material("right"));
  mesh.corner_texcoord.clear();
  save(mesh);
  EXPECT_THAT(report_.warnings, ElementsAre(HasSubstr("its faces have no texture coordinates")));
  EXPECT_THAT(model_.images, IsEmpty());
}

}  // namespace
}  // namespace flexkey::testing
