// Keys that are known but not built yet: one warning each, and the shot runs on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "timeline/parsing.h"

namespace flexkey {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string ignored(const std::string& place, const std::string& key) {
  std::string line = "shot.yaml:";
  return line.append(place).append(": warning: '").append(key).append("' is not built yet and is ignored");
}

TEST(Warnings, OfTopLevelKeys) {
  EXPECT_THAT(warnings_of(with_base("vars: [1, [2]]\nposes:\nattach: 3\n")),
              ElementsAre(ignored("4:1", "vars"), ignored("5:1", "poses"), ignored("6:1", "attach")));
}

TEST(Warnings, OfHandleKeys) {
  EXPECT_THAT(warnings_of(with_tip("    parent: base\n    follow: {path: arc}\n    wave: {}\n    noise: {}\n"
                                   "    motion: {csv: a.csv}\n    pose: {}\n"
                                   "    repeat: 2\n    delay: 1s\n    mirror: {of: a}\n")),
              ElementsAre(ignored("5:5", "parent"), ignored("6:5", "follow"), ignored("7:5", "wave"),
                          ignored("8:5", "noise"), ignored("9:5", "motion"), ignored("10:5", "pose"),
                          ignored("11:5", "repeat"), ignored("12:5", "delay"), ignored("13:5", "mirror")));
}

TEST(Warnings, EulerAnglesAreLeftOut) {
  const std::string text = with_tip("    rotate: {euler: xyz, keys: {0s: [0deg, 0deg, 0deg]}}\n");
  EXPECT_THAT(warnings_of(text), ElementsAre(ignored("5:14", "euler")));
  EXPECT_TRUE(parse(text).handles.at(0).rotate.empty());
}

TEST(Warnings, OfMeshAndLambda) {
  const std::string text =
      "mesh: {file: a.glb, nodes: all, up: z}\nhandles: {base: {select: {group: a}}}\n"
      "lambda: {keys: {0s: 1}, regions: [{value: 7}]}\n";
  EXPECT_THAT(warnings_of(text), ElementsAre(ignored("1:33", "up"), ignored("3:25", "regions")));
}

TEST(Warnings, OfOutputs) {
  EXPECT_THAT(warnings_of(with_base("output: {gltf: a.glb, preview: 1, html: x.html, report: r}\n")),
              ElementsAre(ignored("4:23", "preview"), ignored("4:49", "report")));
  EXPECT_THAT(warnings_of(with_base(
                  "output: {gltf: {path: a.glb, basis: pca, profile: web, encoding: float, split: auto}}\n")),
              ElementsAre(ignored("4:73", "split")));
}

TEST(Warnings, OfLoops) {
  EXPECT_THAT(warnings_of(with_base("loop: cycle\n")),
              ElementsAre("shot.yaml:4:7: warning: loop 'cycle' is not built yet and is ignored"));
  EXPECT_THAT(warnings_of(with_base("loop: none\n")), IsEmpty());
}

TEST(Warnings, AreNotGivenForWhatIsBuilt) {
  EXPECT_THAT(
      warnings_of(with_base("version: 1\noutput: {gltf: {path: a.glb, profile: exact, tolerance: 0.1%, "
                            "normals: none}}\n")),
      IsEmpty());
  EXPECT_THAT(warnings_of(with_base("clips: {in: [0s, 1s]}\noutput: {gltf: {path: a.glb, basis: pca, "
                                    "profile: web, encoding: float}}\n")),
              IsEmpty());
}

TEST(Warnings, StandOnceWhereAnAliasRepeatsThem) {
  EXPECT_THAT(warnings_of("mesh: a.obj\nhandles:\n  a: &a {select: {group: a}, repeat: 2}\n  b: *a\n"),
              ElementsAre(ignored("3:30", "repeat")));
}

}  // namespace
}  // namespace flexkey
