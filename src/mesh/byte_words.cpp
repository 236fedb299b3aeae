#include "flexkey/mesh/byte_words.h"

#include <fmt/format.h>

#include "flexkey/mesh/error.h"

namespace flexkey {

void ByteWords::fail(std::string_view message) const {
  throw InputError(fmt::format("{}: at byte {}: {}", name_, last_, message));
}

void ByteWords::skip(std::size_t bytes, std::string_view what) {
  last_ = at_;
  if (bytes > left_.size()) fail(fmt::format("the file ends where {} should stand", what));
  left_.remove_prefix(bytes);
  at_ += bytes;
}

std::uint64_t ByteWords::bits(std::size_t bytes, std::string_view what) {
  const std::string_view number = left_.substr(0, bytes);
  skip(bytes, what);
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < bytes; ++k) {
    const std::size_t byte = order_ == std::endian::big ? k : bytes - 1 - k;
    bits = bits << 8U | static_cast<unsigned char>(number[byte]);
  }
  return bits;
}

}  // namespace flexkey
