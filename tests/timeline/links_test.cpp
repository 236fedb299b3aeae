// Handles that name other handles.
#include <gtest/gtest.h>

#include "flexkey/timeline/sampling.h"
#include "timeline/parsing.h"

namespace flexkey {
namespace {

std::string two_handles(const std::string& a, const std::string& b) {
  return "mesh: bar.obj\nhandles:\n  a: {select: {group: a}" + a + "}\n  b: {select: {group: b}" + b + "}\n";
}

TEST(Links, MayNameHandlesThatComeLater) {
  const Shot shot = parse(two_handles(", parent: b", ", mirror: {of: a, plane: y}"));
  EXPECT_EQ(shot.handles.at(0).parent, 1);
  EXPECT_EQ(shot.handles.at(1).mirror->of, 0);
  EXPECT_EQ(shot.handles.at(1).mirror->normal, Vec3::UnitY());
}

TEST(Links, AMirroredHandleMovesAsLongAsItsSource) {
  EXPECT_EQ(parse(two_handles(", move: {keys: {2s: [0, 0, 1]}}", ", mirror: {of: a, plane: y}, delay: 1s"))
                .duration,
            3);
}

TEST(Links, WhatIsWrongIsSaidWithItsPlace) {
  EXPECT_EQ(errors_of(two_handles(", parent: bb", "")),
            "shot.yaml:3:35: error: unknown handle 'bb'; did you mean 'b'?");
  EXPECT_EQ(errors_of(two_handles(", parent: b", ", parent: a")),
            "shot.yaml:3:35: error: the parent of handle 'a' comes back to 'a' itself\n"
            "shot.yaml:4:35: error: the parent of handle 'b' comes back to 'b' itself");
  EXPECT_EQ(errors_of(two_handles(", mirror: {of: a, plane: x}", "")),
            "shot.yaml:3:40: error: the mirror of handle 'a' comes back to 'a' itself");
  EXPECT_EQ(
      errors_of(two_handles("", ", mirror: {of: a, plane: q}")),
      "shot.yaml:4:50: error: 'plane' is x, y or z, the axis across which left and right change places, not "
      "'q'");
  EXPECT_EQ(errors_of(two_handles("", ", mirror: {of: a, plane: x}, move: {keys: {0s: [0, 0, 0]}}")),
            "shot.yaml:4:54: error: 'mirror' and 'move' exclude each other in handle 'b'");
}

TEST(Mirror, ReflectsOffsetsAndTurnsTheOtherWay) {
  HandleMotion motion;
  motion.scale = Vec3(1, 2, 3);
  motion.rotation = {Vec3(1, 2, 2) / 3, 0.7};
  motion.further = {{Vec3::UnitY(), 0.4}};
  motion.move = Vec3(1, 2, 3);
  const Vec3 pivot(0.3, 0.1, -2), normal = Vec3::UnitX();
  const Eigen::Vector3d across(-1, 1, 1);
  const HandleMotion other = mirrored(motion, normal);
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(1, 5, -2)}) {
    const Vec3 seen = across.cwiseProduct(motion.apply(x, pivot));
    EXPECT_LT((other.apply(across.cwiseProduct(x), across.cwiseProduct(pivot)) - seen).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace flexkey
