#pragma once

#include <array>
#include <cstdint>

namespace flexkey {

/// What every file of a state begins with. Files of another version, or from a machine that lays its bytes
/// out otherwise, are not read.
struct StateMark {
  std::array<char, 16> name{};
  std::uint32_t version = 1;
  std::uint32_t byte_order = 0x01020304;
  friend bool operator==(const StateMark&, const StateMark&) = default;
};

}  // namespace flexkey
