#include "flexkey/cache/npy.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <string_view>

namespace flexkey {
namespace {

constexpr std::size_t alignment = 64;  // of the values in the file, as NumPy writes it

/// type: NumPy's, without the byte order: "f8".
std::string header_of(std::string_view type, const NpyShape& shape) {
  constexpr char order = std::endian::native == std::endian::little ? '<' : '>';
  // A tuple of one has a comma behind it.
  std::string header = fmt::format("{{'descr': '{}{}', 'fortran_order': False, 'shape': ({}{}), }}", order,
                                   type, fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
  constexpr std::size_t before = 10;  // magic, version, length
  header.append((alignment - (before + header.size() + 1) % alignment) % alignment, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes.push_back(static_cast<char>(header.size() & 0xffU));
  bytes.push_back(static_cast<char>(header.size() >> 8));
  return bytes + header;
}

std::string with_values(std::string header, std::span<const std::byte> values) {
  header.append(reinterpret_cast<const char*>(values.data()), values.size());
  return header;
}

/// The characters of valid UTF-8.
std::u32string characters_of(std::string_view text) {
  std::u32string characters;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      characters.push_back(byte);
    } else if (byte < 0xC0) {  // one of those that follow: six more bits
      if (!characters.empty()) characters.back() = characters.back() << 6 | (byte & 0x3FU);
    } else {  // the first of two to four
      const unsigned int kept = byte < 0xE0 ? 0x1FU : byte < 0xF0 ? 0x0FU : 0x07U;
      characters.push_back(byte & kept);
    }
  }
  return characters;
}

}  // namespace

std::string npy_bytes(std::span<const double> values, const NpyShape& shape) {
  return with_values(header_of("f8", shape), std::as_bytes(values));
}

std::string npy_bytes(std::span<const int> values, const NpyShape& shape) {
  return with_values(header_of("i4", shape), std::as_bytes(values));
}

std::string npy_bytes(const std::vector<std::string>& names) {
  std::vector<std::u32string> texts;
  std::size_t longest = 1;  // NumPy knows no text type of length 0
  for (const std::string& name : names) {
    texts.push_back(characters_of(name));
    longest = std::max(longest, texts.back().size());
  }
  std::u32string all;
  for (const std::u32string& text : texts) all.append(text).append(longest - text.size(), U'\0');
  return with_values(header_of(fmt::format("U{}", longest), {names.size()}), std::as_bytes(std::span(all)));
}

}  // namespace flexkey
