#include "flexkey/timeline/sources.h"

#include <fmt/format.h>

#include "flexkey/mesh/error.h"

namespace flexkey {

Sources no_sources() {
  return {[](const std::string& path) -> std::string {
            throw InputError(fmt::format("'{}' cannot be read here", path));
          },
          [](const std::string& path, const std::string&) -> MotionTracks {
            throw InputError(fmt::format("'{}' cannot be read here", path));
          }};
}

}  // namespace flexkey
