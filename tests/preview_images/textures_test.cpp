#include "flexkey/preview/images/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "flexkey/preview/images/image_file.h"
#include "preview_images/test_folder.h"

namespace flexkey {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class TexturesOf : public test::TestFolder {
 protected:
  /// Red and green above blue and white.
  void write_image(const std::string& name) const {
    write_picture({2, 2, {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}}, folder() / name);
  }
  static Mesh mesh_of(const std::vector<std::string>& images) {
    Mesh mesh;
    for (const std::string& image : images) mesh.materials.push_back({"m", {1, 1, 0}, 1, image});
    return mesh;
  }
};

TEST_F(TexturesOf, ShowTheImageWithVUpwards) {
  write_image("a.png");
  const Textures textures = load_textures(mesh_of({"a.png"}), folder());
  EXPECT_THAT(textures.warnings, IsEmpty());
  const auto at = [&](float u, float v) { return textures.lookup(0, {u, v}); };
  EXPECT_LT((at(0.25f, 0.75f) - Rgb(1, 0, 0)).norm(), 1e-5f);
  EXPECT_LT((at(0.75f, 0.75f) - Rgb(0, 1, 0)).norm(), 1e-5f);
  EXPECT_LT((at(0.25f, 0.25f) - Rgb(0, 0, 1)).norm(), 1e-5f);
  EXPECT_LT((at(0.5f, 0.75f) - Rgb(0.5f, 0.5f, 0)).norm(), 1e-5f) << "halfway between two pixels";
  EXPECT_LT((at(-2.75f, 5.75f) - Rgb(1, 0, 0)).norm(), 1e-5f) << "repeated";
}

TEST_F(TexturesOf, FallBackToTheMaterialsColourWithAWarning) {
  write_image("b.png");
  const Textures textures = load_textures(mesh_of({"none.png", "b.png", "none.png", ""}), folder());
  EXPECT_THAT(textures.warnings, ElementsAre(HasSubstr("none.png")));
  for (const int material : {0, 2, 3}) EXPECT_EQ(textures.lookup(material, {0.5f, 0.5f}), Rgb(1, 1, 0));
  EXPECT_LT((textures.lookup(1, {0.25f, 0.75f}) - Rgb(1, 0, 0)).norm(), 1e-5f);
}

}  // namespace
}  // namespace flexkey
