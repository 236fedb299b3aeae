#include "flexkey/mesh/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw OutputError(fmt::format("cannot write '{}': {}", path.string(), std::strerror(error)));
}

/// A file without a name in the folder of `path`, of which a killed program leaves nothing; -1 where the file
/// system has none, or nothing to name it by later.
int open_nameless(const std::filesystem::path& path) {
  if (access("/proc/self/fd", X_OK) != 0) return -1;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  return open(folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
}

bool give_name(int descriptor, const std::filesystem::path& name) {
  unlink(name.c_str());  // of another program that had this one's number and was killed
  const std::string link = fmt::format("/proc/self/fd/{}", descriptor);
  return linkat(AT_FDCWD, link.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)) {
  struct stat there {};
  if (stat(path_.c_str(), &there) == 0 && S_ISDIR(there.st_mode)) fail(path_, EISDIR);
  std::error_code error;
  if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), error);
  if (error) fail(path_, error.value());

  // A device or pipe such as /dev/null cannot be replaced by a renamed file: it is written as it is.
  const bool in_place = stat(path_.c_str(), &there) == 0 && !S_ISREG(there.st_mode);
  if (!in_place) descriptor_ = open_nameless(path_);
  is_nameless_ = descriptor_ >= 0;
  if (is_nameless_) return;
  if (!in_place) temporary_ = name_beside();
  const std::filesystem::path& opened = in_place ? path_ : temporary_;
  descriptor_ = open(opened.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(path_, errno);
}

std::filesystem::path OutputFile::name_beside() const {
  return fmt::format("{}.part-{}", path_.string(), getpid());
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path_, errno);
    if (written == 0) fail(path_, ENOSPC);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    bytes_written_ += static_cast<std::uintmax_t>(written);
  }
}

void OutputFile::write(std::string_view text) {
  write(std::as_bytes(std::span(text)));
}

void OutputFile::commit() {
  // Network file systems report a full disk only on sync or close. A device or pipe knows no sync (EINVAL).
  if (fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) fail(path_, errno);
  if (is_nameless_) {  // a link cannot replace a file, a renamed one does
    const std::filesystem::path name = name_beside();
    if (!give_name(descriptor_, name)) fail(path_, errno);
    temporary_ = name;
  }
  const int closed = close(descriptor_);
  descriptor_ = -1;
  if (closed != 0) fail(path_, errno);
  if (temporary_.empty()) return;
  if (rename(temporary_.c_str(), path_.c_str()) != 0) fail(path_, errno);
  temporary_.clear();
}

}  // namespace flexkey
