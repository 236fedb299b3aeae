#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace flexkey::test {

/// An attribute of a prim: `point3f[] points = […] (interpolation = …)`.
struct UsdaAttribute {
  std::string type;         // with `uniform` before it where it is that
  nlohmann::json value;     // tuples and lists are arrays, time samples an object by time code as written
  nlohmann::json metadata;  // an object
};

struct UsdaPrim {
  std::string type, name;
  std::map<std::string, UsdaAttribute> attributes;
  std::vector<UsdaPrim> children;
};

struct UsdaFile {
  nlohmann::json metadata;
  std::vector<UsdaPrim> prims;
};

/// Reads what the grammar of USD's text files allows of prims, attributes and metadata; throws
/// std::runtime_error for anything else.
UsdaFile read_usda(const std::string& text);

}  // namespace flexkey::test
