#include "flexkey/gltf/read_accessor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "flexkey/mesh/error.h"
#include "support/gltf_builder.h"

namespace flexkey::testing {
namespace {

using meshes::GltfBuilder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

RawElements elements_of(const GltfBuilder& file, int accessor, const std::vector<int>& chosen) {
  const GltfScene scene = parse_gltf_scene(file.root.dump());
  const std::vector<unsigned char> bytes(file.bytes.begin(), file.bytes.end());
  return AccessorReader(scene, bytes).elements(accessor, chosen);
}

TEST(RawElements, ArePaddedToFourBytes) {
  GltfBuilder file;
  const int colors =
      file.add_accessor(std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 8, 255}, 3, {{"normalized", true}});
  const RawElements elements = elements_of(file, colors, {2, 0});
  EXPECT_THAT(elements.bytes, ElementsAre(7, 8, 255, 0, 1, 2, 3, 0));
  EXPECT_EQ(elements.component_type, 5121);
  EXPECT_EQ(elements.columns, 3);
  EXPECT_TRUE(elements.normalized);
  EXPECT_EQ(elements.values, (AccessorRows(2, 3) << 7, 8, 255, 1, 2, 3).finished()) << "as they stand";
}

TEST(RawElements, SparseOnesArePutIn) {
  for (const bool has_view : {true, false}) {
    GltfBuilder file;
    const int accessor = file.add_accessor(std::vector<std::uint16_t>{10, 11, 12}, 1);
    GltfBuilder::json& sparse = file.root["accessors"][0];
    if (!has_view) sparse.erase("bufferView");
    sparse["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", file.add_view(std::vector<std::uint8_t>{1})}, {"componentType", 5121}}},
        {"values", {{"bufferView", file.add_view(std::vector<std::uint16_t>{99})}}}};
    const RawElements elements = elements_of(file, accessor, {0, 1});
    EXPECT_THAT(elements.bytes, ElementsAre(has_view ? 10 : 0, 0, 0, 0, 99, 0, 0, 0));
  }
}

TEST(RawElements, WhatIsNotThereIsAnError) {
  GltfBuilder file;
  file.add_accessor(std::vector<float>(4, 0), 1);
  file.add_accessor(std::vector<float>(16, 0), 16);
  const auto message_of = [&](int accessor, int element) -> std::string {
    try {
      elements_of(file, accessor, {element});
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(message_of(0, 4), HasSubstr("accessor 0 has 4 elements, and a face names element 4"));
  EXPECT_THAT(message_of(1, 0), HasSubstr("accessor 1 has matrices"));
  file.root["accessors"][0]["count"] = 5;
  EXPECT_THAT(message_of(0, 4), HasSubstr("reaches beyond its buffer view"));
}

}  // namespace
}  // namespace flexkey::testing
