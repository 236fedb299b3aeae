// Runs the Khronos glTF-Validator on written files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "flexkey/gltf/write_glb.h"
#include "gltf/clips.h"
#include "gltf/images.h"

namespace flexkey::testing {
namespace {

using ::testing::HasSubstr;

struct Outcome {
  int status = -1;
  std::string output;
};

Outcome run(const std::string& command) {
  Outcome result;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return result;
  for (int byte = std::fgetc(pipe); byte != EOF; byte = std::fgetc(pipe))
    result.output += static_cast<char>(byte);
  result.status = pclose(pipe);
  return result;
}

class Validator : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::filesystem::path folder = VALIDATE_FOLDER;
    if (run("node --version 2>&1").status != 0 ||
        !std::filesystem::exists(folder / "node_modules/gltf-validator")) {
      GTEST_SKIP() << "glTF-Validator is not installed: run `npm ci` in " << folder << " (needs Node.js)";
    }
  }

  void save(const std::string& name, const Clip& clip, const GltfOptions& options = exact()) {
    write_glb(clip, options, folder_ / name);
    files_ += " '" + (folder_ / name).string() + "'";
  }

  Outcome validate() const { return run("node '" VALIDATE_FOLDER "/validate.mjs'" + files_ + " 2>&1"); }

  TemporaryFolder folder_;
  std::string files_;
};

/// The sheet in two materials; with texture coordinates where there is a texture for them.
Mesh two_halves(const std::string& texture) {
  Mesh mesh = sheet(6);
  mesh.materials = {material("left"), material("right")};
  mesh.materials[1].opacity = 0.5;
  for (Material& one : mesh.materials) one.texture = texture;
  if (!texture.empty()) unwrap_flat(mesh);
  for (int f = 0; f < mesh.face_count(); ++f) mesh.face_material.push_back(f % 6 < 3 ? 0 : 1);
  return mesh;
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

GltfOptions web() {
  GltfOptions options;
  options.basis = BasisKind::pca;
  options.encoding = Encoding::meshopt;
  return options;
}

TEST_F(Validator, FindsNothingToSayOfWrittenFiles) {
  GltfOptions flat = exact();
  flat.normals = false;
  GltfOptions textured = exact();
  textured.texture_folder = folder_.path();
  std::ofstream(folder_ / "map.png", std::ios::binary) << red_png();
  std::ofstream(folder_ / "map.jpg", std::ios::binary) << grey_jpeg();
  Mesh grouped = cube();
  grouped.groups = {{"a \"b\"\n\xFF", {0, 2}}};

  save("twist.glb", clip_of(cube(), 30, twist));
  save("flat.glb", clip_of(cube(), 30, twist), flat);
  save("bump.glb", clip_of(sheet(20), 12, bump));
  save("still.glb", clip_of(sheet(3), 5, stay));
  save("one.glb", clip_of(cube(), 1, twist));
  save("halves.glb", clip_of(two_halves(""), 4, bump));
  save("png.glb", clip_of(two_halves("map.png"), 4, bump), textured);
  save("jpeg.glb", clip_of(two_halves("map.jpg"), 4, bump), textured);
  save("groups.glb", clip_of(grouped, 2, twist));
  GltfOptions textured_web = web();
  textured_web.texture_folder = folder_.path();
  save("web.glb", clip_of(sheet(20), 20, twist), web());
  save("web_png.glb", clip_of(two_halves("map.png"), 4, bump), textured_web);

  const Outcome result = validate();
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_EQ(count(result.output, ": 0 errors, 0 warnings, 0 infos, 0 hints"), 9) << result.output;
  // The validator does not look into compressed views, and says so.
  EXPECT_EQ(count(result.output, ": 0 errors, 0 warnings, 1 infos, 0 hints"), 2) << result.output;
  EXPECT_EQ(count(result.output, "info: UNSUPPORTED_EXTENSION"), 2) << result.output;
}

TEST_F(Validator, FindsADamagedFile) {
  save("sound.glb", clip_of(cube(), 3, twist));
  std::fstream file(folder_ / "sound.glb", std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(-4, std::ios::end);
  file.write("\xFF\xFF\xFF\xFF", 4);  // the last weight becomes no number
  file.close();
  const Outcome result = validate();
  EXPECT_NE(result.status, 0);
  EXPECT_THAT(result.output, HasSubstr("error: ACCESSOR_INVALID_FLOAT"));
}

TEST_F(Validator, ATextFileIsNoGlb) {
  std::ofstream(folder_ / "text.glb") << "text";
  files_ = " '" + (folder_ / "text.glb").string() + "' '" + (folder_ / "missing.glb").string() + "'";
  const Outcome result = validate();
  EXPECT_NE(result.status, 0);
  EXPECT_THAT(result.output, HasSubstr("text.glb"));
  EXPECT_THAT(result.output, HasSubstr("missing.glb: cannot be validated"));
}

}  // namespace
}  // namespace flexkey::testing
