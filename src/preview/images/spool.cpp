#include "flexkey/preview/images/spool.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

[[noreturn]] void fail(const std::filesystem::path& beside, int error) {
  throw OutputError(fmt::format("cannot write '{}': its frames cannot be kept beside it: {}", beside.string(),
                                std::strerror(error)));
}

}  // namespace

Spool::Spool(const std::filesystem::path& beside, std::size_t block_length)
    : beside_(beside), block_length_(block_length) {
  std::error_code error;
  if (beside.has_parent_path()) std::filesystem::create_directories(beside.parent_path(), error);
  if (error) fail(beside_, error.value());
  std::string name = (beside.parent_path() / ".frames-XXXXXX").string();
  descriptor_ = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) fail(beside_, errno);
  unlink(name.c_str());
}

Spool::~Spool() {
  close(descriptor_);
}

void Spool::add(const std::vector<std::uint8_t>& block) {
  for (std::size_t done = 0; done < block_length_;) {
    const auto place = static_cast<off_t>(blocks_ * block_length_ + done);
    const ssize_t written = pwrite(descriptor_, block.data() + done, block_length_ - done, place);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(beside_, written < 0 ? errno : ENOSPC);
    done += static_cast<std::size_t>(written);
  }
  ++blocks_;
}

std::vector<std::uint8_t> Spool::block(std::size_t index) const {
  std::vector<std::uint8_t> block(block_length_);
  for (std::size_t done = 0; done < block_length_;) {
    const auto place = static_cast<off_t>(index * block_length_ + done);
    const ssize_t taken = pread(descriptor_, block.data() + done, block_length_ - done, place);
    if (taken < 0 && errno == EINTR) continue;
    if (taken <= 0) fail(beside_, taken < 0 ? errno : EIO);
    done += static_cast<std::size_t>(taken);
  }
  return block;
}

}  // namespace flexkey
