#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace flexkey {

enum class PlyFormat { text, little_endian, big_endian };

/// How a number of a PLY is stored.
struct PlyType {
  enum class Kind { whole, positive, floating };  // positive: a whole number without a sign
  Kind kind = Kind::floating;
  std::size_t bytes = 4;
};

struct PlyProperty {
  std::string name;
  PlyType type;  // of a list: of its items
  bool is_list = false;
  PlyType count_type;  // of a list
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::text;
  std::vector<PlyElement> elements;  // in the order of the file
  std::size_t bytes = 0;             // that it takes
  int lines = 0;
};

/// Reads what stands before the data. name: of the file, for messages. Throws InputError with the line.
PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

}  // namespace flexkey
