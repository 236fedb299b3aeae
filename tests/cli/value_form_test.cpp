#include "cli/value_form.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "flexkey/timeline/keys.h"

namespace flexkey::cli {
namespace {

TEST(ValueForms, AreReadWithTheirRangesAndContents) {
  const KeyForm key = parse_key_form("required 'all' | list(text | range) | number(0,1] | {track of point}");
  EXPECT_TRUE(key.is_required);
  ASSERT_EQ(key.forms.size(), 4u);
  EXPECT_EQ(key.forms[0].name, "'all'");
  ASSERT_EQ(key.forms[1].of.size(), 2u);
  EXPECT_EQ(key.forms[1].of[1].name, "range");
  EXPECT_FALSE(key.forms[2].least->is_inside);
  EXPECT_EQ(key.forms[2].most->value, 1);
  EXPECT_TRUE(key.forms[2].most->is_inside);
  EXPECT_EQ(key.forms[3].name, "{track}");
  EXPECT_EQ(key.forms[3].of.at(0).name, "point");
  EXPECT_FALSE(parse_key_form("whole[0,]").forms[0].most);
}

TEST(ValueForms, OfAllKeysAreRight) {
  for (const MappingSpec* mapping : all_mappings())
    for (const KeySpec& key : mapping->keys) EXPECT_NO_THROW(parse_key_form(key.form)) << key.form;
  for (const char* wrong : {"", "'open", "list(text", "number[a,]", "text )", "|"})
    EXPECT_THROW(parse_key_form(wrong), std::invalid_argument) << wrong;
}

}  // namespace
}  // namespace flexkey::cli
