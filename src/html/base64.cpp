#include "flexkey/html/base64.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace flexkey {

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr std::size_t group = 3;  // bytes that make four digits
  std::string text;
  text.reserve((bytes.size() + group - 1) / group * (group + 1));
  for (std::size_t begin = 0; begin < bytes.size(); begin += group) {
    const std::size_t count = std::min(group, bytes.size() - begin);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < group; ++i)
      bits = bits << 8 | (i < count ? static_cast<unsigned char>(bytes[begin + i]) : 0u);
    for (std::size_t digit = 0; digit <= group; ++digit)
      text += digit <= count ? digits[bits >> (18 - 6 * digit) & 63u] : '=';
  }
  return text;
}

}  // namespace flexkey
