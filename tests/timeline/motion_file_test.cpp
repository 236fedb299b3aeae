// Motions from tables and from nodes of files.
#include <gtest/gtest.h>

#include <numbers>

#include "flexkey/timeline/motion_table.h"
#include "flexkey/timeline/sampling.h"
#include "timeline/parsing.h"

namespace flexkey {
namespace {

constexpr double pi = std::numbers::pi;

HandleMotion motion_at(const std::string& table, double time) {
  const Sources sources = files({{"rig.csv", table}});
  const Shot shot = parse_shot(with_tip("    motion: {csv: rig.csv}\n"), "shot.yaml", {}, sources).shot;
  return sample_motion(shot.handles.at(0), Vec3::Zero(), time);
}

TEST(MotionTable, IsRelativeToItsFirstSampleAndLinearBetween) {
  const std::string table = "0, 5, 0, 0\n2, 7, 4, 0\n";
  EXPECT_EQ(motion_at(table, 0).move, Vec3(0, 0, 0));
  EXPECT_LT((motion_at(table, 1).move - Vec3(1, 2, 0)).norm(), 1e-12);
  EXPECT_LT((motion_at(table, 9).move - Vec3(2, 4, 0)).norm(), 1e-12);
}

TEST(MotionTable, HasAnglesAboutXFirst) {
  const Eigen::Matrix3d x(Eigen::AngleAxisd(pi / 2, Vec3::UnitX())),
      z(Eigen::AngleAxisd(pi / 2, Vec3::UnitZ()));
  EXPECT_LT((motion_at("0 0 0 0 0 0 0\n1 0 0 0 90 0 90\n", 1).turn() - z * x).norm(), 1e-12);
}

TEST(MotionTable, HasColumnsByName) {
  const std::string table = "qw;qx;qy;qz;time\n1;0;0;0;0\n0.70710678118654757;0;0.70710678118654757;0;1\n";
  const Eigen::Matrix3d y(Eigen::AngleAxisd(pi / 2, Vec3::UnitY()));
  EXPECT_LT((motion_at(table, 1).turn() - y).norm(), 1e-12);
  EXPECT_EQ(motion_at(table, 1).move, Vec3(0, 0, 0));
}

TEST(MotionTable, TurnsFromItsFirstSampleAboutTheWorld) {
  const std::string table = "0 0 0 0 90 0 0\n1 0 0 0 90 0 90\n";
  const Eigen::Matrix3d z(Eigen::AngleAxisd(pi / 2, Vec3::UnitZ()));
  EXPECT_LT((motion_at(table, 1).turn() - z).norm(), 1e-12);
}

TEST(MotionTable, EitherSignOfAQuaternionIsTheSameMotion) {
  const auto table = [](const std::string& sign) {
    return "0 0 0 0 0 0 0 1\n1 0 0 0 0 0 " + sign + "0.6 " + sign + "0.8\n";
  };
  EXPECT_LT((motion_at(table(""), 0.5).turn() - motion_at(table("-"), 0.5).turn()).norm(), 1e-12);
}

TEST(MotionFile, ANodeComesFromTheFilesReader) {
  Sources sources = no_sources();
  sources.node_motion = [](const std::string& path, const std::string& node) {
    EXPECT_EQ(path, "rig.glb");
    EXPECT_EQ(node, "Ear_L");
    return relative_tracks({{0, {1, 1, 1}}, {1, {1, 1, 3}}});
  };
  const Shot shot =
      parse_shot(with_tip("    motion: {from: rig.glb#Ear_L}\n"), "shot.yaml", {}, sources).shot;
  EXPECT_EQ(sample_motion(shot.handles.at(0), Vec3::Zero(), 1).move, Vec3(0, 0, 2));
  EXPECT_EQ(shot.duration, 1);
}

TEST(MotionFile, WhatIsWrongIsSaidWithItsPlace) {
  const auto errors = [](const std::string& table) {
    return errors_of(with_tip("    motion: {csv: rig.csv}\n"), {}, files({{"rig.csv", table}}));
  };
  EXPECT_EQ(
      errors("0 1 2\n"),
      "shot.yaml:5:19: error: rig.csv: line 1: 3 numbers; 4 are a time and an offset, 7 have angles and 8 a "
      "quaternion beside them");
  EXPECT_EQ(errors("0 1 2 3\n1 1 2\n"), "shot.yaml:5:19: error: rig.csv: line 2: 3 numbers, where 4 belong");
  EXPECT_EQ(errors("0 1 2 3\n0 1 2 3\n"),
            "shot.yaml:5:19: error: rig.csv: line 2: the time 0 does not come after that of the line before");
  EXPECT_EQ(errors("time tx ty tzz\n"),
            "shot.yaml:5:19: error: rig.csv: line 1: unknown column 'tzz'; did you mean 'tz'?");
  EXPECT_EQ(errors("tx ty tz\n"), "shot.yaml:5:19: error: rig.csv: line 1: there is no column 'time'");
  EXPECT_EQ(errors("0 0 0 0 0 0 0 0\n"),
            "shot.yaml:5:19: error: rig.csv: line 1: the quaternion 0 0 0 0 is no rotation");
  EXPECT_EQ(errors(""), "shot.yaml:5:19: error: rig.csv: it has no line of numbers");
  EXPECT_EQ(errors_of(with_tip("    motion: {from: rig.glb}\n")),
            "shot.yaml:5:20: error: 'rig.glb' names no node; write it behind a #, as in rig.glb#Ear_L");
  EXPECT_EQ(errors_of(with_tip("    motion: {}\n")),
            "shot.yaml:5:13: error: 'motion' of handle 'tip' comes 'from' a node of a file or from a 'csv'");
}

}  // namespace
}  // namespace flexkey
