#include "flexkey/gltf/json_fields.h"

#include <fmt/format.h>

#include "flexkey/mesh/error.h"

namespace flexkey {

void refuse_member(const char* key, const std::string& what, const std::string& problem) {
  throw InputError(fmt::format("'{}' of {} {}", key, what, problem));
}

void refuse_absence(const char* key, const std::string& what) {
  throw InputError(fmt::format("{} has no '{}'", what, key));
}

}  // namespace flexkey
