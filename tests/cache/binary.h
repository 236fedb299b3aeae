#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace flexkey::test {

enum class Order { little, big };

/// Reads numbers one after another from a file's bytes; past the end is an error.
class BinaryReader {
 public:
  BinaryReader(std::string bytes, Order order) : bytes_(std::move(bytes)), order_(order) {}

  std::string text(std::size_t length) {
    if (at_ + length > bytes_.size()) throw std::runtime_error("the file ends too early");
    at_ += length;
    return bytes_.substr(at_ - length, length);
  }
  std::uint32_t number(int bytes) {
    std::uint32_t value = 0;
    const std::string read = text(static_cast<std::size_t>(bytes));
    for (int k = 0; k < bytes; ++k) {
      const int place = order_ == Order::little ? k : bytes - 1 - k;
      value += static_cast<std::uint32_t>(static_cast<unsigned char>(read[static_cast<std::size_t>(k)]))
               << (8 * place);
    }
    return value;
  }
  int whole() { return static_cast<int>(number(4)); }
  float real() {
    const std::uint32_t bits = number(4);
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  void go_to(std::size_t place) { at_ = place; }
  bool at_end() const { return at_ == bytes_.size(); }

 private:
  std::string bytes_;
  Order order_;
  std::size_t at_ = 0;
};

}  // namespace flexkey::test
