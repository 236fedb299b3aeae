#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/work_folder.h"
#include "flexkey/mesh/read_file.h"
#include "support/gltf_builder.h"

namespace flexkey {
namespace {

using meshes::GltfBuilder;
using meshes::Tube;
using nlohmann::json;
using test::ProgramResult;
using testing::HasSubstr;

/// tube.glb lies in the folder.
class GltfInput : public test::WorkFolder {
 protected:
  void SetUp() override {
    WorkFolder::SetUp();
    meshes::tube_file().save(folder() / "tube.glb");
    write("shot.yaml", shot("tube.glb"));
  }
  static std::string shot(const std::string& mesh) {
    return "mesh: " + mesh +
           "\nhandles:\n"
           "  base: {select: {axis: z, below: 1%}}\n"
           "  tip: {select: {axis: z, above: 99%}, move: {keys: {0s: [0, 0, 0], 0.5s: [1, 0, 0]}}}\n"
           "output: out.glb\n";
  }
};

TEST_F(GltfInput, ChecksTheSurfaceWeldedAlongTheSeam) {
  const ProgramResult result = run({"check", "shot.yaml", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json report = json::parse(result.output);
  EXPECT_EQ(report["mesh"]["vertices"], Tube().vertex_count());
  EXPECT_EQ(report["mesh"]["surface_vertices"], 56);
  EXPECT_EQ(report["mesh"]["groups"][0]["name"], "tube");
  EXPECT_EQ(report["handles"][1]["vertices"], 9) << "both sides of the seam";
  EXPECT_EQ(result.errors, "");
}

TEST_F(GltfInput, SelectsByACustomAttribute) {
  GltfBuilder file = meshes::tube_file();
  std::vector<float> heights;
  for (const Vec3& point : Tube().points()) heights.push_back(static_cast<float>(point.z()));
  file.root["meshes"][0]["primitives"][0]["attributes"]["_HEIGHT"] = file.add_accessor(heights, 1);
  file.save(folder() / "tube.glb");
  const json report = json::parse(
      run({"check", "shot.yaml", "--json", "--set", "handles.tip.select={attribute: _HEIGHT, above: 100%}"})
          .output);
  EXPECT_EQ(report["handles"][1]["vertices"], 9);
  EXPECT_THAT(
      run({"check", "shot.yaml", "--set", "handles.tip.select={attribute: _HIGHT, above: 100%}"}).errors,
      HasSubstr("no attribute '_HIGHT' in tube.glb; did you mean '_HEIGHT'?"));
}

TEST_F(GltfInput, AnUnknownNodeIsBlamedOnItsPlace) {
  write("shot.yaml", shot("{file: tube.glb, nodes: [tub]}"));
  const ProgramResult result = run({"check", "shot.yaml"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.errors, "shot.yaml:1:32: error: no node 'tub' in tube.glb; did you mean 'tube'?\n");
  const ProgramResult set = run({"check", "shot.yaml", "--set", "mesh=tube.glb#tubs"});
  EXPECT_EQ(set.exit_code, 2);
  EXPECT_EQ(set.errors, "--set mesh: error: no node 'tubs' in tube.glb; did you mean 'tube'?\n");
}

TEST_F(GltfInput, ABrokenFileIsBadInput) {
  write("tube.glb", "glTF");
  const ProgramResult result = run({"check", "shot.yaml"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.errors, HasSubstr("tube.glb: the file ends inside the header of a GLB"));
}

TEST_F(GltfInput, TheHashCoversBuffersBesideTheFile) {
  GltfBuilder file = meshes::tube_file();
  file.root["buffers"] = {{{"byteLength", file.bytes.size()}, {"uri", "tube.bin"}}};
  write("tube.gltf", file.root.dump());
  write("shot.yaml", shot("tube.gltf"));
  const auto hash = [&] {
    write("tube.bin", file.bytes);
    const ProgramResult result = run({"animate", "shot.yaml", "--json", "-q"});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return json::parse(result.output).at("hash").get<std::string>();
  };
  const std::string before = hash();
  EXPECT_EQ(hash(), before);
  file.bytes[0] ^= 1;  // the last bit of the first vertex's x
  EXPECT_NE(hash(), before);
}

TEST_F(GltfInput, NoOutputReplacesABufferOfTheInput) {
  GltfBuilder file = meshes::tube_file();
  file.root["buffers"] = {{{"byteLength", file.bytes.size()}, {"uri", "out.glb"}}};
  write("tube.gltf", file.root.dump());
  write("out.glb", file.bytes);
  write("shot.yaml", shot("tube.gltf"));
  const ProgramResult result = run({"check", "shot.yaml"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("the output './out.glb' would replace an input"));
}

/// The JSON chunk of a GLB.
json json_of(const std::string& glb) {
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, sizeof length);
  return json::parse(glb.substr(20, length));
}

TEST_F(GltfInput, AnimateWritesTheFileWithAnAnimationMore) {
  for (const char* profile : {"compat", "web", "exact"}) {
    const ProgramResult result =
        run({"animate", "shot.yaml", "--set",
             std::string("output={gltf: {path: out.glb, profile: ") + profile + "}}"});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    const json root = json_of(read_file(folder() / "out.glb"));
    EXPECT_EQ(root["nodes"], meshes::tube_file().root["nodes"]);
    EXPECT_EQ(root["materials"], meshes::tube_file().root["materials"]);
    EXPECT_EQ(root["animations"][0]["name"], "shot");
    EXPECT_EQ(root["meshes"][0]["extras"]["profile"], profile);
    EXPECT_EQ(root["meshes"][0]["weights"].size(), root["meshes"][0]["primitives"][0]["targets"].size());
  }
}

TEST_F(GltfInput, TheReportSaysWhatTheTargetsTakeOfASplitMesh) {
  write("shot.yaml",
        "mesh: tube.glb\n"
        "roi: {axis: z, above: 75%}\n"
        "handles: {tip: {select: {axis: z, above: 99%}, move: {keys: {0s: [0, 0, 0], 0.5s: [1, 0, 0]}}}}\n"
        "output: {gltf: {path: out.glb, profile: exact, split: auto}}\n");
  const ProgramResult split = run({"animate", "shot.yaml", "--json"});
  ASSERT_EQ(split.exit_code, 0) << split.errors;
  const json output = json::parse(split.output)["runs"][0]["outputs"][0];
  EXPECT_EQ(output["splits"][0]["mesh"], "tube");
  EXPECT_EQ(output["splits"][0]["split"], true);
  EXPECT_EQ(output["splits"][0]["targeted"], output["target_vertices"]);
  EXPECT_LT(output["target_vertices"], output["vertices"]);
  const auto gpu_bytes = [&](const char* vertices) {
    return 32 * output[vertices].get<int>() * output["targets"].get<int>();
  };
  EXPECT_EQ(output["gpu_bytes"], gpu_bytes("target_vertices"));
  EXPECT_EQ(output["gpu_bytes_whole"], gpu_bytes("vertices"));
  EXPECT_THAT(
      run({"animate", "shot.yaml"}).errors,
      HasSubstr("13 targets of 36 vertices take 15.0 kB of GPU memory, instead of 26.2 kB of all 63"));
  EXPECT_THAT(run({"animate", "shot.yaml", "--set", "roi.above=10%"}).errors,
              HasSubstr("'tube' is not split: "));
  EXPECT_THAT(run({"animate", "shot.yaml", "--set", "output.gltf.split=none"}).errors,
              HasSubstr("13 targets of 63 vertices take 26.2 kB of GPU memory\n"));
}

TEST_F(GltfInput, WhatWasWrittenCanBeAnimatedAgain) {
  ASSERT_EQ(run({"animate", "shot.yaml"}).exit_code, 0);
  write("again.yaml", shot("out.glb"));
  const ProgramResult result =
      run({"animate", "again.yaml", "--set", "output={gltf: {path: again.glb, animation: second}}"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json root = json_of(read_file(folder() / "again.glb"));
  ASSERT_EQ(root["animations"].size(), 2u);
  EXPECT_EQ(root["animations"][1]["name"], "second");
  const auto names = root["meshes"][0]["extras"]["targetNames"].get<std::vector<std::string>>();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size()) << "names are unique";
}

TEST_F(GltfInput, AnAnimationToMergeIntoHasToBeThere) {
  const auto errors_with = [&](const std::string& mesh, const std::string& more) {
    write("shot.yaml", shot(mesh) + more);
    return run({"check", "shot.yaml", "--set",
                "output={gltf: {path: out.glb, animation: {merge_into: Wak}}}"})
        .errors;
  };
  EXPECT_EQ(errors_with("tube.glb", ""),
            "--set output: error: no animation 'Wak' in tube.glb; it has no animations\n");
  EXPECT_EQ(errors_with("bar.obj", ""),
            "--set output: error: there is no animation 'Wak': bar.obj is no glTF file\n");
  EXPECT_EQ(errors_with("tube.glb", "clips: {a: [0s, 0.5s]}\n"),
            "--set output: error: 'merge_into' takes one animation, and 'clips' makes several\n");
}

TEST_F(GltfInput, HandlesAreWrittenAsNodesOnRequest) {
  const ProgramResult result =
      run({"animate", "shot.yaml", "--set", "output={gltf: {path: out.glb, handles: true}}"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json root = json_of(read_file(folder() / "out.glb"));
  ASSERT_EQ(root["nodes"].size(), 3u);
  EXPECT_EQ(root["nodes"][2]["name"], "tip");
  EXPECT_NEAR(root["nodes"][2]["translation"][2].get<double>(), 6, 1e-6);
  ASSERT_EQ(root["animations"][0]["channels"].size(), 2u);
  const json channel = root["animations"][0]["channels"][1];
  EXPECT_EQ(channel["target"], (json{{"node", 2}, {"path", "translation"}}));
  const json sampler = root["animations"][0]["samplers"][channel["sampler"].get<std::size_t>()];
  const json output = root["accessors"][sampler["output"].get<std::size_t>()];
  EXPECT_EQ(output["count"], 13);
  EXPECT_NEAR(output["max"][0].get<double>(), 1, 1e-6);
}

}  // namespace
}  // namespace flexkey
