// What is built gives no warning.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "timeline/parsing.h"

namespace flexkey {
namespace {

using testing::IsEmpty;

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
