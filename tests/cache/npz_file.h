#pragma once

#include <map>
#include <string>
#include <vector>

namespace flexkey::test {

/// A .npy file of format version 1.0, read from NumPy's description of it.
struct NpyFile {
  std::string type;  // such as "<f8"
  std::vector<int> shape;
  std::string values;  // the bytes behind the header

  std::vector<double> doubles() const;  // throws for another type
  std::vector<int> ints() const;
  std::vector<std::u32string> texts() const;  // without the zeros behind them
};

/// The files of a ZIP archive without compression, by name. Throws std::runtime_error for what is not one:
/// a wrong place or length, a wrong checksum.
std::map<std::string, NpyFile> read_npz(const std::string& archive);

}  // namespace flexkey::test
