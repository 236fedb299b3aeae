#include "flexkey/gltf/extras.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "flexkey/gltf/basis.h"
#include "flexkey/gltf/write_glb.h"
#include "gltf/clips.h"
#include "gltf/glb_file.h"

namespace flexkey::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

tinygltf::Model written(const Clip& clip, const GltfOptions& options = exact()) {
  const TemporaryFolder folder;
  write_glb(clip, options, folder / "shot.glb");
  return load_glb(folder / "shot.glb");
}

template <typename T>
std::vector<T> list(const tinygltf::Value& value) {
  std::vector<T> items;
  for (std::size_t i = 0; i < value.ArrayLen(); ++i) items.push_back(value.Get(static_cast<int>(i)).Get<T>());
  return items;
}

TEST(Extras, NameATargetAFrame) {
  const tinygltf::Model model = written(clip_of(cube(), 3, twist));
  EXPECT_THAT(list<std::string>(model.meshes[0].extras.Get("targetNames")),
              ElementsAre("f0000", "f0001", "f0002"));
  EXPECT_EQ(target_name(12345), "f12345");
}

TEST(Extras, TellWhereMeshAndAnimationCameFrom) {
  Clip clip = clip_of(cube(), 3, twist);
  clip.fps = 12.5;
  clip.reports[2].frame = 7;
  GltfOptions options = exact();
  options.hash = "a1b2c3";
  const tinygltf::Model model = written(clip, options);
  for (const tinygltf::Value& extras : {model.meshes[0].extras, model.animations[0].extras}) {
    EXPECT_EQ(extras.Get("profile").Get<std::string>(), "exact");
    EXPECT_EQ(extras.Get("fps").GetNumberAsDouble(), 12.5);
    EXPECT_EQ(extras.Get("frames").GetNumberAsInt(), 3);
    EXPECT_EQ(extras.Get("hash").Get<std::string>(), "a1b2c3");
    EXPECT_THAT(list<double>(extras.Get("lambda")), ElementsAre(0.5, 0.51, 0.52));
    EXPECT_THAT(list<int>(extras.Get("sourceFrames")), ElementsAre(0, 1, 7));
    EXPECT_LT(extras.Get("error").GetNumberAsDouble(), 1e-7);
    EXPECT_TRUE(extras.Has("kgError"));
    EXPECT_TRUE(extras.Has("normalErrorLargest"));
  }
  EXPECT_EQ(model.asset.generator, "flexkey " FLEXKEY_VERSION);
}

TEST(Extras, SomeFramesOfAShotKeepTheirNumbersAndBeginAtZero) {
  Clip clip = clip_of(cube(), 3, twist);
  clip.fps = 4;
  for (const int k : {0, 1, 2}) clip.reports[static_cast<std::size_t>(k)].frame = 10 + k * k;
  const tinygltf::Model model = written(clip);
  EXPECT_THAT(list<std::string>(model.meshes[0].extras.Get("targetNames")),
              ElementsAre("f0010", "f0011", "f0014"));
  const tinygltf::Accessor& times =
      model.accessors[static_cast<std::size_t>(model.animations[0].samplers[0].input)];
  EXPECT_THAT(times.minValues, ElementsAre(0));
  EXPECT_THAT(times.maxValues, ElementsAre(1));
}

TEST(Extras, GroupsBecomeRunsOfTriangles) {
  Mesh mesh = cube();
  mesh.groups = {{"ends", {0, 1, 5}}, {"none", {}}, {"middle", {3}}};
  const tinygltf::Model model = written(clip_of(mesh, 1, stay));
  const tinygltf::Value& groups = model.meshes[0].primitives[0].extras.Get("groups");
  ASSERT_EQ(groups.ArrayLen(), 2u);
  EXPECT_EQ(groups.Get(0).Get("name").Get<std::string>(), "ends");
  EXPECT_THAT(list<int>(groups.Get(0).Get("triangles")), ElementsAre(0, 4, 10, 2));
  EXPECT_EQ(groups.Get(1).Get("name").Get<std::string>(), "middle");
  EXPECT_THAT(list<int>(groups.Get(1).Get("triangles")), ElementsAre(6, 2));
}

TEST(Extras, NamesThatAreNoUtf8AreMended) {
  Mesh mesh = cube();
  mesh.groups = {{"Fu\xDF", {0}}};
  mesh.materials = {material("gr\xFCn")};
  mesh.face_material.assign(6, 0);
  Clip clip = clip_of(mesh, 2, twist);
  clip.name = "sch\xF6n";
  GltfOptions options = exact();
  options.hash = "\xFF";
  const tinygltf::Model model = written(clip, options);
  EXPECT_EQ(model.materials[0].name, "gr\uFFFDn");
  EXPECT_EQ(model.nodes[0].name, "sch\uFFFDn");
  EXPECT_EQ(model.meshes[0].primitives[0].extras.Get("groups").Get(0).Get("name").Get<std::string>(),
            "Fu\uFFFD");
}

TEST(Extras, ManyTargetsAreWarnedOf) {
  const TemporaryFolder folder;
  EXPECT_THAT(write_glb(clip_of(cube(), 128, twist), exact(), folder / "shot.glb").warnings,
              ::testing::IsEmpty());
  EXPECT_THAT(write_glb(clip_of(cube(), 129, twist), exact(), folder / "shot.glb").warnings,
              ElementsAre(HasSubstr("129 morph targets")));
}

}  // namespace
}  // namespace flexkey::testing
