#pragma once

#include <string>
#include <string_view>

namespace flexkey::testing {

using namespace std::string_view_literals;

/// A PNG of one red pixel.
inline std::string red_png() {
  return std::string(
      "\x89PNG\r\n\x1A\n"
      "\x00\x00\x00\x0DIHDR\x00\x00\x00\x01\x00\x00\x00\x01\x08\x02\x00\x00\x00\x90\x77\x53\xDE"
      "\x00\x00\x00\x0CIDAT\x78\x9C\x63\xF8\xCF\xC0\x00\x00\x03\x01\x01\x00\xC9\xFE\x92\xEF"
      "\x00\x00\x00\x00IEND\xAE\x42\x60\x82"sv);
}

/// A baseline JPEG of one grey pixel: its only block has no coefficient, and each Huffman table a single
/// code.
inline std::string grey_jpeg() {
  const std::string start = "\xFF\xD8";
  const std::string quantization = std::string("\xFF\xDB\x00\x43\x00"sv) + std::string(64, '\x01');
  const std::string frame(
      "\xFF\xC0\x00\x0B\x08\x00\x01\x00\x01\x01\x01\x11\x00"sv);  // 8 bits, 1 x 1, one component
  const std::string one_code = "\x01" + std::string(15, '\0') + std::string(1, '\0');
  const std::string dc = std::string("\xFF\xC4\x00\x14\x00"sv) + one_code;
  const std::string ac = std::string("\xFF\xC4\x00\x14\x10"sv) + one_code;
  const std::string scan("\xFF\xDA\x00\x08\x01\x01\x00\x00\x3F\x00\x3F"sv);
  return start + quantization + frame + dc + ac + scan + "\xFF\xD9";
}

}  // namespace flexkey::testing
