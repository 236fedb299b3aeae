#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace flexkey {

/// Largest magnitude of a number: far beyond any scene, and its square and cube are still finite.
inline constexpr double largest_number = 1e30;

/// A decimal number that fills the whole text: "-.52", "1e-4", "+3". Nothing for hexadecimal, octal-looking
/// ("010"), infinite and NaN spellings and for magnitudes above `largest_number`.
std::optional<double> parse_number(std::string_view text);

/// A whole number that fills the whole text, in the same spelling.
std::optional<int> parse_whole(std::string_view text);

/// What keeps a text from being a number: "'0x10' is hexadecimal; numbers are decimal".
std::string number_problem(std::string_view text);

/// Without the spaces at both ends.
std::string_view trimmed(std::string_view text);

/// The shortest decimal text that reads back as the same number: "0.2", "1".
std::string number_text(double number);

}  // namespace flexkey
