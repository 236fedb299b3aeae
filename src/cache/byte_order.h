#pragma once

#include <bit>
#include <cstdint>
#include <string>

namespace flexkey {

/// Appends the four bytes of a number, the least significant first.
inline void append_little_endian(std::string& bytes, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(number >> shift & 0xffU));
}

/// Appends the four bytes of a number, the most significant first.
inline void append_big_endian(std::string& bytes, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(number >> shift & 0xffU));
}

/// The bits of an IEEE 754 single, and of a count that a file keeps in 32 bits with a sign.
inline std::uint32_t bits_of(float number) {
  return std::bit_cast<std::uint32_t>(number);
}
inline std::uint32_t bits_of(int number) {
  return std::bit_cast<std::uint32_t>(number);
}

}  // namespace flexkey
