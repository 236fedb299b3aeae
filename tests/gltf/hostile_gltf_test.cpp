// Files that are wrong, whether by accident or on purpose: a clear error, and never more than that.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "flexkey/gltf/read_gltf.h"
#include "flexkey/gltf/write_glb.h"
#include "gltf/clips.h"
#include "support/gltf_builder.h"

namespace flexkey::testing {
namespace {

using json = nlohmann::json;
using meshes::GltfBuilder;
using meshes::tube_file;
using meshes::tube_with_targets;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class HostileGltf : public ::testing::Test {
 protected:
  /// What reading these bytes says; empty where it goes well.
  std::string problem_of(const std::string& bytes) const {
    const std::filesystem::path path = folder_ / "pig.glb";
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
    try {
      read_gltf(path);
    } catch (const InputError& error) {
      const std::string message = error.what(), name = path.string() + ": ";
      EXPECT_THAT(message, StartsWith(name));
      return message.substr(std::min(name.size(), message.size()));
    }
    return "";
  }

  /// The same after a change to the tube's JSON.
  std::string problem_with(const std::function<void(json&)>& change) const {
    GltfBuilder file = tube_file();
    change(file.root);
    return problem_of(file.glb());
  }

  TemporaryFolder folder_;
};

TEST_F(HostileGltf, TheTubeItselfIsSound) {
  EXPECT_EQ(problem_of(tube_file().glb()), "");
}

TEST_F(HostileGltf, Framing) {
  const std::string sound = tube_file().glb();
  EXPECT_EQ(problem_of(""), "it is no glTF: it begins neither with 'glTF' nor with '{'");
  EXPECT_EQ(problem_of("solid cube"), "it is no glTF: it begins neither with 'glTF' nor with '{'");
  EXPECT_EQ(problem_of("glTF"), "the file ends inside the header of a GLB");
  EXPECT_THAT(problem_of(sound.substr(0, sound.size() - 1)), HasSubstr("the file ends after"));
  std::string old = sound;
  old[4] = 1;
  EXPECT_EQ(problem_of(old), "it is a GLB of version 1; flexkey reads version 2");
  std::string short_file = sound;
  short_file.replace(8, 4, std::string("\0\0\0\0", 4));
  EXPECT_EQ(problem_of(short_file), "the GLB has 0 bytes, fewer than its header");
  std::string long_chunk = sound;
  long_chunk.replace(12, 4, "\xFF\xFF\xFF\xFF");
  EXPECT_THAT(problem_of(long_chunk), StartsWith("chunk 0 has 4294967295 bytes, and the file ends after"));
  std::string binary_first = sound;
  binary_first.replace(16, 4, std::string("BIN\0", 4));
  EXPECT_EQ(problem_of(binary_first), "chunk 0 of the GLB is not its JSON");
  std::string no_chunk = "glTF" + std::string("\2\0\0\0\14\0\0\0", 8);
  EXPECT_EQ(problem_of(no_chunk), "the file ends inside the header of chunk 0");
}

TEST_F(HostileGltf, Json) {
  EXPECT_THAT(problem_of("{\"asset\": "), StartsWith("its JSON cannot be read: parse error at line 1"));
  EXPECT_THAT(problem_of("{\"a\": \"\xFF\"}"), StartsWith("its JSON cannot be read: "));
  EXPECT_THAT(problem_of("{\"a\": 1e999}"), StartsWith("its JSON cannot be read: number overflow"));
  EXPECT_THAT(problem_of(GltfBuilder::frame("[1]", "")), StartsWith("its JSON is not an object"));
  EXPECT_EQ(problem_of("{\"a\": " + std::string(100'000, '[')), "its JSON is nested more than 100 deep");
  std::string objects = "{\"a\": ";
  for (int i = 0; i < 50'000; ++i) objects += "{\"a\": ";
  EXPECT_EQ(problem_of(objects), "its JSON is nested more than 100 deep");
  EXPECT_EQ(problem_of("{}"), "its asset version is null; flexkey reads glTF 2");
  EXPECT_EQ(problem_of("{\"asset\": [\"version\"]}"), "its asset version is null; flexkey reads glTF 2");
  EXPECT_EQ(problem_of("{\"asset\": {\"version\": \"1.0\"}}"),
            "its asset version is \"1.0\"; flexkey reads glTF 2");
  EXPECT_EQ(problem_of("{\"asset\": {\"version\": \"2.0\"}}"), "no node of its scene shows a mesh");
}

TEST_F(HostileGltf, ValuesOfAWrongType) {
  EXPECT_EQ(problem_with([](json& root) { root["accessors"] = 7; }), "'accessors' of the file is not a list");
  EXPECT_EQ(problem_with([](json& root) { root["nodes"][0] = 7; }),
            "'name' of node 0 is read of what is no JSON object");
  EXPECT_EQ(problem_with([](json& root) { root["accessors"][1]["count"] = -3; }),
            "'count' of accessor 1 is not a whole number from 0");
  EXPECT_EQ(problem_with([](json& root) { root["accessors"][1]["count"] = 1.5; }),
            "'count' of accessor 1 is not a whole number from 0");
  EXPECT_EQ(problem_with([](json& root) { root["accessors"][1].erase("count"); }),
            "accessor 1 has no 'count'");
  EXPECT_EQ(problem_with([](json& root) { root["accessors"][1]["type"] = "VEC9"; }),
            "accessor 1 is of an unknown type, 'VEC9'");
  EXPECT_EQ(problem_with([](json& root) {
              root["nodes"][0]["translation"] = {1, 2};
            }),
            "'translation' of node 0 has 2 numbers, not 3");
  EXPECT_EQ(problem_with([](json& root) {
              root["nodes"][0]["scale"] = {1, "2", 3};
            }),
            "'scale' of node 0 has an item that is no number");
  EXPECT_EQ(
      problem_with([](json& root) { root["meshes"][0]["primitives"][0]["attributes"] = json::array({0}); }),
      "'attributes' of primitive 0 of mesh 0 are not a JSON object");
}

TEST_F(HostileGltf, IndicesOfThingsThatAreNotThere) {
  EXPECT_EQ(problem_with([](json& root) { root["nodes"][0]["mesh"] = 1; }),
            "'mesh' of node 0 is 1, and the file has 1");
  EXPECT_EQ(problem_with([](json& root) { root["nodes"][0]["mesh"] = -1; }),
            "'mesh' of node 0 is not a whole number from 0");
  EXPECT_EQ(problem_with([](json& root) {
              root["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 4294967296;
            }),
            "'POSITION' of 'attributes' of primitive 0 of mesh 0 is 4294967296, and the file has 4");
  EXPECT_EQ(problem_with([](json& root) { root["accessors"][0]["bufferView"] = 99; }),
            "'bufferView' of accessor 0 is 99, and the file has 4");
  EXPECT_EQ(problem_with([](json& root) { root["bufferViews"][2]["buffer"] = 1; }),
            "'buffer' of buffer view 2 is 1, and the file has 1");
  EXPECT_EQ(problem_with([](json& root) { root["scenes"][0]["nodes"] = {5}; }),
            "'nodes' of scene 0 is 5, and the file has 1");
  EXPECT_EQ(problem_with([](json& root) { root["meshes"][0]["primitives"][0]["material"] = 3; }),
            "'material' of primitive 0 of mesh 0 is 3, and the file has 1");
}

TEST_F(HostileGltf, RangesThatReachBeyondTheirBytes) {
  const std::size_t huge = (std::size_t{1} << 53) - 1;
  EXPECT_EQ(problem_with([](json& root) { root["accessors"][3]["count"] = 289; }),
            "accessor 3 reaches beyond its buffer view: it has 289 elements, and there is room for 288");
  EXPECT_EQ(problem_with([](json& root) { root["accessors"][0]["byteOffset"] = 4; }),
            "accessor 0 reaches beyond its buffer view: it has 63 elements, and there is room for 62");
  EXPECT_EQ(problem_with([&](json& root) { root["accessors"][0]["byteOffset"] = huge; }),
            "accessor 0 reaches beyond its buffer view: it has 63 elements, and there is room for 0");
  EXPECT_THAT(problem_with([&](json& root) { root["accessors"][0]["count"] = huge; }),
              HasSubstr("its nodes have more than 20000000 vertices"));
  EXPECT_EQ(problem_with([&](json& root) { root["accessors"][3]["count"] = huge; }),
            "its nodes have more than 120000000 corners");
  EXPECT_THAT(
      problem_with([&](json& root) { root["bufferViews"][0]["byteStride"] = huge; }),
      HasSubstr("accessor 0 reaches beyond its buffer view: it has 63 elements, and there is room for 1"));
  EXPECT_EQ(problem_with([](json& root) { root["bufferViews"][0]["byteStride"] = 4; }),
            "accessor 0 has elements of 12 bytes, and its buffer view a stride of 4");
  EXPECT_THAT(problem_with([&](json& root) { root["bufferViews"][0]["byteLength"] = huge; }),
              StartsWith("buffer view 0 reaches beyond its buffer: 9007199254740991 bytes from 0 on"));
  EXPECT_THAT(problem_with([&](json& root) { root["bufferViews"][1]["byteOffset"] = huge; }),
              StartsWith("buffer view 1 reaches beyond its buffer"));
}

TEST_F(HostileGltf, ZerosWithoutBytesAreBounded) {
  const auto zeros = [](json& root) { root["accessors"][0].erase("bufferView"); };
  EXPECT_EQ(problem_with(zeros), "") << "63 of them are what the format allows";
  EXPECT_THAT(problem_with([&](json& root) {
                zeros(root);
                root["accessors"][0]["count"] = 15'000'000;
              }),
              StartsWith("accessor 0 has 15000000 elements and no bytes, in a file of"));
}

TEST_F(HostileGltf, Sparse) {
  const auto with_sparse = [&](const std::vector<std::uint16_t>& rows,
                               const std::function<void(json&)>& change) {
    GltfBuilder file = tube_file();
    json sparse = {{"count", rows.size()},
                   {"indices", {{"bufferView", file.add_view(rows)}, {"componentType", 5123}}},
                   {"values", {{"bufferView", file.add_view(std::vector<float>(rows.size() * 3))}}}};
    change(sparse);
    file.root["accessors"][0]["sparse"] = sparse;
    return problem_of(file.glb());
  };
  EXPECT_EQ(with_sparse({3}, [](json&) {}), "");
  EXPECT_EQ(with_sparse({63}, [](json&) {}), "'sparse' of accessor 0 names element 63 of 63");
  EXPECT_EQ(with_sparse({3}, [](json& sparse) { sparse["count"] = 1'000'000'000'000; }),
            "'sparse' of accessor 0 reaches beyond its buffer view: it has 1000000000000 elements, and there "
            "is room "
            "for 1");
  EXPECT_EQ(with_sparse({3}, [](json& sparse) { sparse["indices"]["componentType"] = 5126; }),
            "'sparse' of accessor 0 has indices of type 5126, which is no unsigned integer");
  EXPECT_EQ(with_sparse({3}, [](json& sparse) { sparse.erase("values"); }),
            "'sparse' of accessor 0 has no 'values'");
  EXPECT_EQ(
      with_sparse({3}, [](json& sparse) { sparse["values"]["byteOffset"] = 4; }),
      "'sparse' of accessor 0 reaches beyond its buffer view: it has 1 elements, and there is room for 0");
}

TEST_F(HostileGltf, Numbers) {
  for (const float wrong :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    GltfBuilder file = tube_file();
    std::memcpy(file.bytes.data() + 12 * 5, &wrong, sizeof wrong);
    EXPECT_EQ(problem_of(file.glb()), "accessor 0 has a value at element 5 that is not a finite number");
  }
  GltfBuilder file = tube_file();
  const std::size_t corners = file.root["bufferViews"][3]["byteOffset"];
  file.bytes.replace(corners + 4, 2, "\xFF\xFF");
  EXPECT_EQ(problem_of(file.glb()), "accessor 3 names vertex 65535 of 63");
  EXPECT_EQ(problem_with([](json& root) {
              root["nodes"][0]["scale"] = {1, 0, 1};
            }),
            "the transform of node 0 ('tube') cannot be undone");
  EXPECT_EQ(problem_with([](json& root) {
              root["nodes"][0]["rotation"] = {0, 0, 0, 0};
            }),
            "'rotation' of node 0 is no rotation: all four numbers are 0");
  EXPECT_EQ(problem_with([](json& root) {
              root["nodes"][0]["scale"] = {1e200, 1e200, 1e200};
            }),
            "primitive 0 of mesh 0 reaches farther than floats do");
}

TEST_F(HostileGltf, TypesThatAMeshCannotHave) {
  EXPECT_EQ(problem_with([](json& root) { root["accessors"][0]["type"] = "VEC2"; }),
            "accessor 0 has 2 components an element, not 3");
  EXPECT_EQ(problem_with([](json& root) { root["accessors"][0]["componentType"] = 5130; }),
            "accessor 0 has components of type 5130, which flexkey cannot read");
  EXPECT_EQ(problem_with([](json& root) { root["accessors"][3]["componentType"] = 5126; }),
            "accessor 3 has indices of type 5126, which is no unsigned integer");
  EXPECT_EQ(problem_with([](json& root) { root["accessors"][3].erase("bufferView"); }),
            "accessor 3 is not a plain list of indices");
  EXPECT_EQ(problem_with([](json& root) { root["meshes"][0]["primitives"][0]["mode"] = 7; }),
            "'mode' of primitive 0 of mesh 0 is unknown");
  EXPECT_EQ(problem_with([](json& root) { root["accessors"][1]["count"] = 3; }),
            "primitive 0 of mesh 0 has 63 positions and 3 normals");
  EXPECT_EQ(
      problem_with([](json& root) { root["meshes"][0]["primitives"][0]["attributes"].erase("POSITION"); }),
      "primitive 0 of mesh 0 has no POSITION");
  EXPECT_EQ(problem_with([](json& root) { root["meshes"][0]["primitives"][0]["mode"] = 0; }),
            "the nodes to solve have no triangle");
  EXPECT_EQ(problem_with([](json& root) {
              json& primitives = root["meshes"][0]["primitives"];
              primitives.push_back(primitives[0]);
              primitives[0]["targets"] = {{{"POSITION", 0}}};
            }),
            "primitive 1 of mesh 0 has 0 morph targets, and primitive 0 has 1");
}

TEST_F(HostileGltf, ExtensionsThatAreNeededToReadTheMesh) {
  const char* draco = "KHR_draco_mesh_compression";
  EXPECT_EQ(problem_with([&](json& root) {
              root["meshes"][0]["primitives"][0]["extensions"][draco] = json::object();
            }),
            "primitive 0 of mesh 0 needs KHR_draco_mesh_compression, which flexkey cannot read");
  const auto unknown = [](json& root) {
    root["meshes"][0]["primitives"][0]["extensions"]["NEW_mesh"] = json::object();
  };
  EXPECT_EQ(problem_with(unknown), "");
  EXPECT_EQ(problem_with([&](json& root) {
              unknown(root);
              root["extensionsRequired"] = {"NEW_mesh"};
            }),
            "primitive 0 of mesh 0 needs NEW_mesh, which flexkey cannot read");
}

TEST_F(HostileGltf, NodesThatAreNoTrees) {
  EXPECT_EQ(problem_with([](json& root) { root["nodes"][0]["children"] = {0}; }),
            "the nodes run in a circle: node 0 is above itself");
  EXPECT_EQ(problem_with([](json& root) {
              root["nodes"].push_back({{"children", {2}}});
              root["nodes"].push_back({{"children", {1}}});
            }),
            "the nodes run in a circle: node 1 is above itself");
  EXPECT_EQ(problem_with([](json& root) {
              root["nodes"].push_back({{"children", {0}}});
              root["nodes"].push_back({{"children", {0}}});
            }),
            "node 0 is a child of node 1 and of node 2");
  EXPECT_EQ(problem_with([](json& root) {  // deep enough to end a recursion
              for (int node = 1; node <= 200'000; ++node) root["nodes"].push_back({{"children", {node - 1}}});
            }),
            "");
}

TEST_F(HostileGltf, AMeshOfNothing) {
  EXPECT_EQ(problem_with([](json& root) { root["meshes"][0]["primitives"] = json::array(); }),
            "no node of its scene shows a mesh");
}

TEST_F(HostileGltf, Buffers) {
  const auto buffer = [&](const json& value) {
    return problem_with([&](json& root) { root["buffers"] = json::array({value}); });
  };
  EXPECT_THAT(buffer({{"byteLength", 1'000'000}}),
              HasSubstr("buffer 0 has 2592 bytes, and its 'byteLength' is 1000000"));
  EXPECT_EQ(buffer({{"uri", "x.bin"}}), "buffer 0 has no 'byteLength'");
  EXPECT_EQ(buffer({{"byteLength", 4}, {"uri", "x.bin"}}),
            "buffer 0 ('x.bin') cannot be read: there is no such file");
  EXPECT_EQ(buffer({{"byteLength", 4}, {"uri", "../x.bin"}}),
            "buffer 0 ('../x.bin') cannot be read: it does not lie in the folder of the glTF");
  EXPECT_EQ(buffer({{"byteLength", 4}, {"uri", "a/%2E%2E/../x.bin"}}),
            "buffer 0 ('a/%2E%2E/../x.bin') cannot be read: it does not lie in the folder of the glTF");
  EXPECT_EQ(buffer({{"byteLength", 4}, {"uri", "/etc/passwd"}}),
            "buffer 0 ('/etc/passwd') cannot be read: it does not lie in the folder of the glTF");
  EXPECT_EQ(buffer({{"byteLength", 4}, {"uri", "https://example.org/x.bin"}}),
            "buffer 0 ('https://example.org/x.bin') cannot be read: only files can be read");
  EXPECT_EQ(buffer({{"byteLength", 4}, {"uri", "data:,hello"}}),
            "buffer 0 ('data:,hello') cannot be read: its data URI is not in base64");
  EXPECT_THAT(buffer({{"byteLength", 4}, {"uri", "data:a/b;base64,????"}}),
              HasSubstr("its data URI holds nothing"));
  EXPECT_THAT(buffer({{"byteLength", 400}, {"uri", "data:a/b;base64,AAAA"}}),
              HasSubstr("buffer 0 has 3 bytes, and its 'byteLength' is 400"));
  EXPECT_EQ(problem_with([](json& root) {
              root["buffers"] = {{{"byteLength", 2592}}, {{"byteLength", 1}}};
            }),
            "buffer 1 is missing: it has no 'uri'");
  GltfBuilder no_chunk = tube_file();
  no_chunk.root["buffers"] = json::array({{{"byteLength", no_chunk.bytes.size()}}});
  EXPECT_EQ(problem_of(no_chunk.root.dump()), "buffer 0 is missing: it has no 'uri'");
}

// Whatever a byte is changed to, or wherever the file ends, it is read or refused; a sanitizer sees the rest.
TEST_F(HostileGltf, EveryByteChangedIsReadOrRefused) {
  const std::string sound = tube_file().glb();
  int refused = 0;
  for (std::size_t at = 0; at < sound.size(); at += 11) {
    std::string changed = sound;
    changed[at] = static_cast<char>(changed[at] ^ (at % 2 == 0 ? 0x80 : 0x11));
    refused += problem_of(changed).empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 100);
  for (std::size_t length = 0; length < sound.size(); length += 13)
    EXPECT_NE(problem_of(sound.substr(0, length)), "");
}

/// Writes a clip into the file, with all that can be asked for.
void write_into(const GltfFile& file, const std::filesystem::path& path) {
  GltfOptions options;
  options.source = &file.source;
  options.encoding = Encoding::meshopt;
  if (!file.source.animations.empty()) options.merge_into = file.source.animations[0];
  options.handles = {{"tip", {0, 0, 6}, std::vector<Eigen::Matrix4d>(2, Eigen::Matrix4d::Identity())}};
  write_glb(clip_of(file.file.mesh, 2, twist), options, path);
}

/// Every value in the JSON in turn becomes each of these, and so do the lists and objects around it.
TEST_F(HostileGltf, EveryValueReplacedIsReadAndWrittenOrRefused) {
  const GltfBuilder file = tube_with_targets();
  const std::vector<json> values = {nullptr,       -1,   1e300,          9007199254740991,    0.5, "text",
                                    json::array(), true, json::object(), json::array({0, 0}), 0};
  const json flat = file.root.flatten();
  int refused = 0, count = 0;
  for (const auto& [pointer, value] : flat.items())
    for (const json& other : values)
      for (json::json_pointer at(pointer); !at.empty(); at.pop_back()) {
        if (++count % 5 != 0) continue;  // a different value for each
        GltfBuilder changed = file;
        changed.root[at] = other;
        SCOPED_TRACE(at.to_string() + " = " + other.dump());
        try {
          write_into(read_gltf(changed.save(folder_ / "in.glb")), folder_ / "out.glb");
        } catch (const InputError&) {
          ++refused;
        }
      }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace flexkey::testing
