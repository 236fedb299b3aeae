// How handles hold, and what moves as one body: `weight`, `rigid`, `active`, `fade`.
#include <gtest/gtest.h>

#include "flexkey/timeline/sampling.h"
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

TEST(Active, IsAlwaysOneIntervalOrSeveral) {
  EXPECT_TRUE(parse_tip("").active.empty());
  const Handle once = parse_tip("    active: [12f, 1s]\n");
  ASSERT_EQ(once.active.size(), 1u);
  EXPECT_EQ(once.active[0].from, 0.5);
  EXPECT_EQ(once.active[0].to, 1);
  EXPECT_EQ(parse_tip("    active: [[0s, 1s], [1s, 2s], [3s, 4s]]\n").active.size(), 3u);
  EXPECT_EQ(parse("times: {hit: 2s}\n" + with_tip("    active: [hit, hit+12f]\n")).handles[0].active[0].to,
            2.5);
}

TEST(Active, TakesInItsBeginningAndNotItsEnd) {
  const Handle handle = parse_tip("    active: [[1s, 2s], [3s, 4s]]\n");
  for (const double time : {1.0, 1.5, 3.0, 3.999}) EXPECT_TRUE(is_active(handle, time)) << time;
  for (const double time : {0.0, 0.999, 2.0, 2.5, 4.0}) EXPECT_FALSE(is_active(handle, time)) << time;
  EXPECT_TRUE(is_active(parse_tip(""), 0));
}

TEST(Active, HandlesAreTogetherWhereTheirTimesMeet) {
  const Handle always = parse_tip(""), early = parse_tip("    active: [0s, 1s]\n");
  const Handle late = parse_tip("    active: [[1s, 2s], [3s, 4s]]\n"),
               across = parse_tip("    active: [0.5s, 9s]\n");
  EXPECT_TRUE(active_together(always, late));
  EXPECT_FALSE(active_together(early, late));
  EXPECT_TRUE(active_together(across, late));
  EXPECT_TRUE(active_together(across, early));
}

TEST(Fade, TakesHoldAndLetsGoSmoothly) {
  const Handle handle = parse_tip("    active: [1s, 3s]\n    fade: 0.5s\n");
  EXPECT_EQ(handle.fade, 0.5);
  EXPECT_EQ(sample_grip(handle, 0.5), 0);
  EXPECT_EQ(sample_grip(handle, 1), 0);
  EXPECT_NEAR(sample_grip(handle, 1.25), 0.5, 1e-12);
  EXPECT_EQ(sample_grip(handle, 1.5), 1);
  EXPECT_EQ(sample_grip(handle, 2.5), 1);
  EXPECT_NEAR(sample_grip(handle, 2.75), 0.5, 1e-12);
  EXPECT_LT(sample_grip(handle, 2.99), 0.01);
  EXPECT_EQ(sample_grip(handle, 3), 0);
  EXPECT_EQ(sample_grip(parse_tip("    active: [1s, 3s]\n"), 1), 1);
  EXPECT_EQ(sample_grip(parse_tip(""), 7), 1);
}

TEST(Active, ErrorsStandAtTheirPlace) {
  const std::pair<const char*, const char*> table[] = {
      {"active: [2s, 1s]", "5:13: error: 'active' of handle 'tip' is from 2s to 1s, which is no time at all"},
      {"active: [1s, 1s]", "5:13: error: 'active' of handle 'tip' is from 1s to 1s, which is no time at all"},
      {"active: 1s",
       "5:13: error: 'active' of handle 'tip' is [from, to) such as [1s, 2s], or a list of such, "
       "not '1s'"},
      {"active: []",
       "5:13: error: 'active' of handle 'tip' is [from, to) such as [1s, 2s], or a list of such, "
       "not a list"},
      {"active: [[0s, 2s], [1s, 3s]]",
       "5:24: error: 'active' of handle 'tip' has times that overlap or go back"},
      {"active: [[0s, 2s], 3s]",
       "5:24: error: 'active' of handle 'tip' is [from, to) such as [1s, 2s], or a "
       "list of such, not '3s'"},
      {"fade: 1s",
       "5:5: error: 'fade' of handle 'tip' says how it takes hold and lets go; say when, with "
       "'active'"},
  };
  for (const auto& [line, message] : table)
    EXPECT_EQ(errors_of(with_tip("    " + std::string(line) + "\n")), "shot.yaml:" + std::string(message));
  EXPECT_EQ(errors_of(with_tip("    active: [0s, 1s]\n    fade: -0.1s\n")),
            "shot.yaml:6:11: error: fade -0.1s is below 0");
  EXPECT_EQ(
      errors_of(with_tip("    active: [[0s, 3s], [4s, 5s]]\n    fade: 0.6s\n")),
      "shot.yaml:6:11: error: fade 0.6s does not fit twice into the 1s that handle 'tip' is active from 4s "
      "on");
}

}  // namespace
}  // namespace flexkey
