#include "flexkey/cache/pc2.h"

#include <gmock/gmock.h>

#include "cache/binary.h"
#include "cache/frames.h"
#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

using test::BinaryReader;
using test::Order;
using test::write_all;

class Pc2 : public test::Folder {};

TEST_F(Pc2, HasItsHeaderAndEverySampleInFloats) {
  const Mesh mesh = test::mixed_mesh();
  const CacheShape shape{"shot", mesh, 24, {0, 1, 2, 3}, {}};
  const std::uintmax_t bytes = write_all(pc2_sink(*this / "a.pc2", shape), shape);
  EXPECT_EQ(bytes, std::filesystem::file_size(*this / "a.pc2"));

  BinaryReader file(read_file(*this / "a.pc2"), Order::little);
  EXPECT_EQ(file.text(12), std::string("POINTCACHE2\0", 12));
  EXPECT_EQ(file.whole(), 1) << "version";
  EXPECT_EQ(file.whole(), 12) << "points";
  EXPECT_EQ(file.real(), 0) << "start frame";
  EXPECT_EQ(file.real(), 1) << "frames a sample";
  EXPECT_EQ(file.whole(), 4) << "samples";
  for (const int k : shape.frames) {
    const Positions positions = test::posed(mesh, k);
    for (const double coordinate : positions.reshaped<Eigen::RowMajor>())
      EXPECT_EQ(file.real(), static_cast<float>(coordinate));
  }
  EXPECT_TRUE(file.at_end());
}

TEST_F(Pc2, SaysWhereSteppedFramesBeginAndHowFarApartTheyAre) {
  const Mesh mesh = meshes::cube();
  const CacheShape shape{"shot", mesh, 24, {10, 13, 16}, {}};
  write_all(pc2_sink(*this / "a.pc2", shape), shape);
  BinaryReader file(read_file(*this / "a.pc2"), Order::little);
  file.go_to(20);
  EXPECT_EQ(file.real(), 10);
  EXPECT_EQ(file.real(), 3);
  EXPECT_EQ(file.whole(), 3);
}

TEST_F(Pc2, RefusesFramesThatAreNotEvenlySpaced) {
  const Mesh mesh = meshes::cube();
  EXPECT_THROW(pc2_sink(*this / "a.pc2", {"shot", mesh, 24, {0, 1, 3}, {}}), OutputError);
  EXPECT_TRUE(is_empty());
}

TEST(EvenStep, IsTheDistanceOfNeighbours) {
  EXPECT_EQ(even_step({7}), 1);
  EXPECT_EQ(even_step({7, 9}), 2);
  EXPECT_EQ(even_step({0, 5, 10, 15}), 5);
  EXPECT_EQ(even_step({0, 5, 10, 14}), 0);
}

}  // namespace
}  // namespace flexkey
