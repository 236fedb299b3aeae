#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace flexkey {

/// Lengths along the axes of an array, the last axis fastest; none for a single value.
using NpyShape = std::vector<std::size_t>;

/// The bytes of a NumPy array file (.npy, format version 1.0) in the byte order of this machine, which the
/// file tells. The values are as many as the shape says.
std::string npy_bytes(std::span<const double> values, const NpyShape& shape);  // float64
std::string npy_bytes(std::span<const int> values, const NpyShape& shape);     // int32

/// An array of texts, all as long as the longest; names are UTF-8.
std::string npy_bytes(const std::vector<std::string>& names);

}  // namespace flexkey
