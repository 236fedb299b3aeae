#include "flexkey/cache/mdd.h"

#include <gmock/gmock.h>

#include "cache/binary.h"
#include "cache/frames.h"

namespace flexkey {
namespace {

using test::BinaryReader;
using test::Order;
using test::write_all;

class Mdd : public test::Folder {};

TEST_F(Mdd, HasCountsTimesAndEveryFrameBigEndian) {
  const Mesh mesh = test::mixed_mesh();
  const CacheShape shape{"shot", mesh, 30, {0, 3, 10}, {}};
  const std::uintmax_t bytes = write_all(mdd_sink(*this / "a.mdd", shape), shape);
  const std::string content = read_file(*this / "a.mdd");
  EXPECT_EQ(bytes, content.size());
  EXPECT_EQ(content.substr(0, 8), std::string("\0\0\0\3\0\0\0\x0c", 8)) << "3 frames of 12 points";

  BinaryReader file(content, Order::big);
  EXPECT_EQ(file.whole(), 3);
  EXPECT_EQ(file.whole(), 12);
  EXPECT_EQ(file.real(), 0.f);
  EXPECT_EQ(file.real(), 0.1f);
  EXPECT_EQ(file.real(), static_cast<float>(10.0 / 30));
  for (const int k : shape.frames) {
    const Positions positions = test::posed(mesh, k);
    for (const double coordinate : positions.reshaped<Eigen::RowMajor>())
      EXPECT_EQ(file.real(), static_cast<float>(coordinate));
  }
  EXPECT_TRUE(file.at_end());
}

}  // namespace
}  // namespace flexkey
