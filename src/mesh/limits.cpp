#include "flexkey/mesh/limits.h"

#include <fmt/format.h>

namespace flexkey::limits {

std::string more_than(std::size_t most, std::string_view what) {
  return fmt::format("more than {} {}", most, what);
}

}  // namespace flexkey::limits
