#include "flexkey/timeline/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace flexkey {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::string_view without_sign(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return text;
}

/// std::from_chars takes a minus, but no plus.
std::string_view without_plus(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  return text;
}

/// "010" is 8 to some readers and 10 to others.
bool looks_octal(std::string_view text) {
  const std::string_view digits = without_sign(text);
  return digits.size() > 1 && digits[0] == '0' && is_digit(digits[1]);
}

bool has_number_spelling(std::string_view text) {
  const std::string_view digits = without_sign(text);
  const bool begins_well = !digits.empty() && (is_digit(digits[0]) || digits[0] == '.');
  return begins_well && text.find_first_not_of("0123456789.eE+-") == std::string_view::npos &&
         !looks_octal(text);
}

template <class Number>
struct FromChars {
  Number number{};
  std::errc error{};
  bool fills = false;
};

template <class Number>
FromChars<Number> from_text(std::string_view text) {
  FromChars<Number> result;
  const std::string_view body = without_plus(text);
  const auto [end, error] = std::from_chars(body.data(), body.data() + body.size(), result.number);
  result.error = error;
  result.fills = end == body.data() + body.size();
  return result;
}

bool is_infinity_or_nan(std::string_view text) {
  std::string word(without_sign(text));
  if (word.starts_with('.')) word.erase(0, 1);
  std::transform(word.begin(), word.end(), word.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
  return word == "inf" || word == "infinity" || word == "nan";
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

std::optional<double> parse_number(std::string_view text) {
  if (!has_number_spelling(text)) return std::nullopt;
  const auto [number, error, fills] = from_text<double>(text);
  if (error != std::errc() || !fills || std::abs(number) > largest_number) return std::nullopt;
  return number;
}

std::optional<int> parse_whole(std::string_view text) {
  if (!has_number_spelling(text)) return std::nullopt;
  const auto [number, error, fills] = from_text<int>(text);
  if (error != std::errc() || !fills) return std::nullopt;
  return number;
}

std::string number_problem(std::string_view text) {
  const std::string_view digits = without_sign(text);
  if (digits.starts_with("0x") || digits.starts_with("0X")) {
    return fmt::format("'{}' is hexadecimal; numbers are decimal", text);
  }
  if (is_infinity_or_nan(text)) return fmt::format("'{}' is not a finite number", text);
  if (looks_octal(text) && digits.find_first_not_of("0123456789.eE+-") == std::string_view::npos) {
    return fmt::format("'{}' begins with 0 and could be octal; write it without the 0", text);
  }
  if (has_number_spelling(text) && from_text<double>(text).fills) {
    return fmt::format("'{}' is out of range; numbers reach from -1e30 to 1e30", text);
  }
  return fmt::format("'{}' is not a number", text);
}

std::string number_text(double number) {
  return fmt::format("{}", number);
}

}  // namespace flexkey
