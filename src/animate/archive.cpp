#include "flexkey/animate/archive.h"

#include <cstring>

namespace flexkey {

void Loading::get(void* data, std::size_t size) {
  if (size > bytes_.size()) fail();
  if (size > 0) std::memcpy(data, bytes_.data(), size);
  bytes_ = bytes_.subspan(size);
}

void Loading::fail() const {
  throw ArchiveError("the archive ends early");
}

}  // namespace flexkey
