#include "cli/state_lock.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

namespace flexkey::cli {
namespace {

bool lock(const Descriptor& file, int kind) {
  return file.is_open() && flock(file.number(), kind | LOCK_NB) == 0;
}

}  // namespace

StateLock StateLock::for_writing(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  StateLock made;
  made.file_ = Descriptor(open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  const std::string unwritable = error ? error.message() : std::strerror(errno);
  if (lock(made.file_, LOCK_EX)) {
    made.holds_ = Holds::writing;
    return made;
  }
  const bool is_open = made.file_.is_open();
  made = for_reading(folder);
  if (!is_open) made.fault_ = unwritable;
  if (is_open && made.holds_ == Holds::reading) made.fault_ = "another flexkey reads it";
  return made;
}

StateLock StateLock::for_reading(const std::filesystem::path& folder) {
  StateLock made;
  made.file_ = Descriptor(open((folder / "lock").c_str(), O_RDONLY | O_CLOEXEC));
  if (lock(made.file_, LOCK_SH)) {
    made.holds_ = Holds::reading;
  } else {
    made.fault_ = made.file_.is_open() ? "another flexkey is solving it" : std::strerror(errno);
  }
  return made;
}

}  // namespace flexkey::cli
