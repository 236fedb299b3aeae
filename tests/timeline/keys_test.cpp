#include "flexkey/timeline/keys.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace flexkey {
namespace {

TEST(KeyTables, NameEveryKeyOnceAndDescribeIt) {
  for (const MappingSpec& spec :
       {shot_keys,   mesh_keys,     handle_keys, selection_keys, sphere_keys, box_keys,
        plane_keys,  geodesic_keys, track_keys,  rotate_keys,    follow_keys, wave_keys,
        noise_keys,  mirror_keys,   turn_keys,   key_keys,       curve_keys,  lambda_keys,
        solver_keys, output_keys,   gltf_keys,   file_keys}) {
    EXPECT_FALSE(spec.keys.empty());
    EXPECT_TRUE(spec.example.starts_with('{') && spec.example.ends_with('}')) << spec.example;
    std::set<std::string_view> names;
    for (const KeySpec& key : spec.keys) {
      EXPECT_TRUE(names.insert(key.name).second) << key.name << " stands twice";
      EXPECT_FALSE(key.about.empty()) << key.name;
    }
  }
}

}  // namespace
}  // namespace flexkey
