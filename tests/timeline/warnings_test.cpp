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

TEST(Warnings, OfMeshAndLambda) {
  const std::string text =
      "mesh: {file: a.glb, nodes: all, up: z}\nhandles: {base: {select: {group: a}}}\n"
      "lambda: {keys: {0s: 1}}\n";
  EXPECT_THAT(warnings_of(text), ElementsAre(ignored("1:33", "up")));
}

TEST(Warnings, OfOutputs) {
  EXPECT_THAT(warnings_of(with_base("output: {gltf: a.glb, preview: p, html: x.html, report: r}\n")),
              ElementsAre(ignored("4:49", "report")));
}

TEST(Warnings, AreNotGivenForWhatIsBuilt) {
  EXPECT_THAT(
      warnings_of(with_base("version: 1\noutput: {gltf: {path: a.glb, profile: exact, tolerance: 0.1%, "
                            "normals: none}}\n")),
      IsEmpty());
  EXPECT_THAT(warnings_of(with_base("loop: ping-pong\n")), IsEmpty());
  EXPECT_THAT(warnings_of(with_base("clips: {in: [0s, 1s]}\noutput: {gltf: {path: a.glb, basis: pca, "
                                    "profile: web, encoding: float}}\n")),
              IsEmpty());
}

}  // namespace
}  // namespace flexkey
