#include "flexkey/timeline/keys.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace flexkey {
namespace {

TEST(KeyTables, NameEveryKeyOnceAndDescribeIt) {
  for (const MappingSpec* mapping : all_mappings()) {
    const MappingSpec& spec = *mapping;
    SCOPED_TRACE(std::string(spec.name));
    EXPECT_FALSE(spec.keys.empty());
    EXPECT_TRUE(spec.example.starts_with('{') && spec.example.ends_with('}')) << spec.example;
    std::set<std::string_view> names;
    for (const KeySpec& key : spec.keys) {
      EXPECT_TRUE(names.insert(key.name).second) << key.name << " stands twice";
      EXPECT_FALSE(key.about.empty()) << key.name;
      EXPECT_FALSE(key.form.empty()) << key.name;
    }
  }
}

}  // namespace
}  // namespace flexkey
