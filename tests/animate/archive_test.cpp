#include "flexkey/animate/archive.h"

#include <gtest/gtest.h>

#include <string>

#include "flexkey/animate/seal.h"
#include "flexkey/mesh/types.h"

namespace flexkey {
namespace {

enum class Colour { red, green };

struct Inner {
  std::string name;
  std::optional<Vec3> place;
};

template <MaybeConst<Inner> Self>
auto members_of(Self& inner) {
  auto& [name, place] = inner;
  return std::tie(name, place);
}

struct Outer {
  int number = 0;
  bool is_set = false;
  Colour colour = Colour::red;
  Positions rows{0, 3};
  Eigen::VectorXd column;
  std::vector<Eigen::Matrix3d> turns;
  std::vector<std::vector<int>> lists;
  std::vector<Inner> inner;
};

template <MaybeConst<Outer> Self>
auto members_of(Self& outer) {
  auto& [number, is_set, colour, rows, column, turns, lists, inner] = outer;
  return std::tie(number, is_set, colour, rows, column, turns, lists, inner);
}

Outer example() {
  return {-7,
          true,
          Colour::green,
          Positions::Random(4, 3),
          Eigen::VectorXd::Random(5),
          {Eigen::Matrix3d::Random(), Eigen::Matrix3d::Identity()},
          {{1, 2, 3}, {}, {4}},
          {{"a", std::nullopt}, {"", Vec3(1, 2, 3)}}};
}

std::string saved(const Outer& outer) {
  std::string bytes;
  Saving saving([&](std::span<const std::byte> more) {
    bytes.append(reinterpret_cast<const char*>(more.data()), more.size());
  });
  saving(outer);
  return bytes;
}

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

TEST(Archive, GivesBackWhatItSaved) {
  const Outer before = example();
  const std::string bytes = saved(before);
  Outer after;
  Loading loading(bytes_of(bytes));
  loading(after);
  EXPECT_TRUE(loading.rest().empty());
  EXPECT_EQ(after.number, before.number);
  EXPECT_EQ(after.is_set, before.is_set);
  EXPECT_EQ(after.colour, before.colour);
  EXPECT_EQ(after.rows, before.rows);
  EXPECT_EQ(after.column, before.column);
  EXPECT_EQ(after.turns, before.turns);
  EXPECT_EQ(after.lists, before.lists);
  ASSERT_EQ(after.inner.size(), 2u);
  EXPECT_EQ(after.inner[0].name, "a");
  EXPECT_FALSE(after.inner[0].place.has_value());
  EXPECT_EQ(after.inner[1].place, before.inner[1].place);
}

TEST(Archive, ThatEndsEarlyIsRefusedAtEveryLength) {
  const std::string bytes = saved(example());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::string part = bytes.substr(0, size);
    Outer outer;
    EXPECT_THROW(Loading{bytes_of(part)}(outer), ArchiveError) << size;
  }
}

TEST(Archive, TakesNoMemoryForWhatIsNotThere) {
  std::string bytes = saved(example());
  for (std::size_t place = 6; place + 8 <= bytes.size(); ++place) {
    std::string huge = bytes;
    huge.replace(place, 8, "\xff\xff\xff\xff\xff\xff\xff\x7f");
    Outer outer;
    try {
      Loading{bytes_of(huge)}(outer);
    } catch (const ArchiveError&) {
    }
    EXPECT_LE(static_cast<std::size_t>(outer.rows.size()) * sizeof(double), bytes.size());
    EXPECT_LE(outer.lists.size() + outer.inner.size() + outer.turns.size(), bytes.size());
  }
}

TEST(Seal, KnowsEveryChangedBit) {
  const std::string whole = sealed(example());
  ASSERT_TRUE(unseal(bytes_of(whole)));
  EXPECT_EQ(unseal(bytes_of(whole))->size(), whole.size() - sizeof(Digest));
  for (std::size_t place = 0; place < whole.size(); ++place) {
    std::string changed = whole;
    changed[place] = static_cast<char>(changed[place] ^ 1);
    EXPECT_FALSE(unseal(bytes_of(changed))) << place;
  }
  EXPECT_FALSE(unseal({}));
}

}  // namespace
}  // namespace flexkey
