#pragma once

#include <optional>
#include <string_view>

namespace flexkey {

/// The number that a word of a mesh file is, "nan" and "inf" included; nothing where it is none.
std::optional<double> number_of(std::string_view word);

/// The whole number that a word is; nothing where it is none or does not fit.
std::optional<long long> whole_number_of(std::string_view word);

/// What is wrong with a coordinate of a mesh, "which is not a finite number"; empty where nothing is.
std::string_view coordinate_fault(std::optional<double> value);

}  // namespace flexkey
