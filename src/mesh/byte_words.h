#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace flexkey {

/// The numbers of a binary file, one after another. Each function throws InputError with the byte where the
/// file ends.
class ByteWords {
 public:
  /// name: of the file, for messages; at: the byte of the file with which these begin.
  ByteWords(std::string_view bytes, std::string name, std::endian order, std::size_t at = 0)
      : left_(bytes), name_(std::move(name)), order_(order), at_(at) {}

  /// A number of 1, 2, 4 or 8 bytes as its bits.
  std::uint64_t bits(std::size_t bytes, std::string_view what);
  float float32(std::string_view what) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(bits(4, what)));
  }
  double float64(std::string_view what) { return std::bit_cast<double>(bits(8, what)); }
  void skip(std::size_t bytes, std::string_view what);

  std::size_t bytes_left() const { return left_.size(); }
  /// The byte named is that of the number read last.
  [[noreturn]] void fail(std::string_view message) const;

 private:
  std::string_view left_;
  std::string name_;
  std::endian order_;
  std::size_t at_, last_ = 0;
};

}  // namespace flexkey
