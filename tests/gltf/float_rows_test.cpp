#include "flexkey/gltf/float_rows.h"

#include <gtest/gtest.h>

namespace flexkey {
namespace {

TEST(FloatRows, KeepsTheRowsThatAreNotAllZero) {
  FloatRows rows = FloatRows::Zero(6, 3);
  rows(1, 2) = 4;
  rows(4, 0) = -1;
  const SparseRows sparse = nonzero_rows(rows);
  EXPECT_EQ(sparse.count, 6);
  EXPECT_EQ(sparse.indices, (std::vector<std::uint32_t>{1, 4}));
  EXPECT_EQ(sparse.values.row(0), rows.row(1));
  EXPECT_EQ(dense_rows(sparse), rows);
}

TEST(FloatRows, KeepsOneRowOfZeros) {
  const SparseRows sparse = nonzero_rows(FloatRows::Zero(6, 3));
  EXPECT_EQ(sparse.indices, std::vector<std::uint32_t>{0});
  EXPECT_TRUE(sparse.values.isZero(0));
}

TEST(FloatRows, CountsBytesWithIndicesAsNarrowAsTheyCanBe) {
  EXPECT_EQ(index_bytes(255), 1);
  EXPECT_EQ(index_bytes(256), 2);
  EXPECT_EQ(index_bytes(65'535), 2);
  EXPECT_EQ(index_bytes(65'536), 4);
  EXPECT_EQ(dense_bytes(10, 3), 120);
  EXPECT_EQ(sparse_bytes(5, 200, 3), 8 + 60);
  EXPECT_EQ(sparse_bytes(5, 300, 3), 12 + 60);
  EXPECT_EQ(sparse_bytes(5, 70'000, 1), 20 + 20);
}

}  // namespace
}  // namespace flexkey
