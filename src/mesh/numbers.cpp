#include "flexkey/mesh/numbers.h"

#include <charconv>
#include <cmath>

#include "flexkey/mesh/limits.h"

namespace flexkey {
namespace {

template <class Number>
std::optional<Number> parsed(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> number_of(std::string_view word) {
  return parsed<double>(word);
}

std::optional<long long> whole_number_of(std::string_view word) {
  return parsed<long long>(word);
}

std::string_view coordinate_fault(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return "which is not a finite number";
  static_assert(limits::coordinate == 1e30);
  return std::abs(*value) > limits::coordinate ? "beyond ±1e30" : "";
}

}  // namespace flexkey
