#include "flexkey/gltf/unique_name.h"

#include <fmt/format.h>

namespace flexkey {

std::string unique_name(const std::string& name, std::set<std::string>& known) {
  std::string unique = name;
  for (int number = 2; !known.insert(unique).second; ++number) unique = fmt::format("{}_{}", name, number);
  return unique;
}

}  // namespace flexkey
