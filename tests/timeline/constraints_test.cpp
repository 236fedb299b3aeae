// How handles hold, and what moves as one body: `weight`, `rigid`.
#include <gtest/gtest.h>

#include "timeline/parsing.h"

namespace flexkey {
namespace {

TEST(Weight, IsOneUnlessGiven) {
  EXPECT_EQ(parse_tip("").weight, 1);
  EXPECT_EQ(parse_tip("    weight: 0.25\n").weight, 0.25);
  EXPECT_EQ(parse_tip("    weight: 1\n").weight, 1);
}

TEST(Weight, LiesAboveZeroAndAtMostAtOne) {
  for (const char* weight : {"0", "-0.5", "1.01"})
    EXPECT_EQ(errors_of(with_tip("    weight: " + std::string(weight) + "\n")),
              "shot.yaml:5:13: error: weight " + std::string(weight) +
                  " is outside 0..1 (above 0, a soft handle, to 1, which is met exactly)");
  EXPECT_EQ(errors_of(with_tip("    weight: soft\n")), "shot.yaml:5:13: error: 'soft' is not a number");
}

TEST(Rigid, IsSelectionsByName) {
  const Shot shot = parse(with_base("rigid: {teeth: {group: teeth}, horn: {axis: z, above: 90%}}\n"));
  ASSERT_EQ(shot.rigid.size(), 2u);
  EXPECT_EQ(shot.rigid[0].name, "teeth");
  EXPECT_EQ(shot.rigid[1].where.line, 4);
  EXPECT_EQ(shot.rigid[1].where.column, 32);
  EXPECT_TRUE(parse(with_base("")).rigid.empty());
}

TEST(Rigid, ErrorsNameTheRegion) {
  EXPECT_EQ(
      errors_of(with_base("rigid: {group: teeth}\n")),
      "shot.yaml:4:16: error: rigid region 'group' must be a mapping such as {axis: z, above: 99%}, not "
      "'teeth'");
  EXPECT_EQ(errors_of(with_base("rigid: [teeth]\n")),
            "shot.yaml:4:8: error: 'rigid' must be a mapping such as {teeth: {group: teeth}}, not a list");
  EXPECT_EQ(errors_of(with_base("rigid: {teeth: }\n")),
            "shot.yaml:4:9: error: rigid region 'teeth' has no selection");
}

}  // namespace
}  // namespace flexkey
