#include "cli/file_watch.h"

#include <fmt/format.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "flexkey/mesh/error.h"

namespace flexkey::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t saved = IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE;

}  // namespace

FileWatch::FileWatch() : descriptor_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  if (descriptor_ < 0) throw Error(fmt::format("cannot watch files: {}", std::strerror(errno)));
}

FileWatch::~FileWatch() {
  close(descriptor_);
}

void FileWatch::follow(const std::vector<fs::path>& files) {
  std::map<int, std::set<std::string>> names;
  std::error_code ignored;
  for (const fs::path& file : files)
    for (const fs::path& place : {fs::absolute(file), fs::weakly_canonical(file, ignored)}) {
      const int folder = inotify_add_watch(descriptor_, place.parent_path().c_str(), saved);
      if (folder >= 0) names[folder].insert(place.filename().string());
    }
  for (const auto& [folder, unused] : names_)
    if (!names.contains(folder)) inotify_rm_watch(descriptor_, folder);
  names_ = std::move(names);
}

std::set<std::string> FileWatch::changed() {
  std::set<std::string> changed;
  alignas(inotify_event) std::array<char, 16384> buffer;
  for (ssize_t length = 0; (length = read(descriptor_, buffer.data(), buffer.size())) > 0;) {
    for (ssize_t at = 0; at < length;) {
      const auto* event = reinterpret_cast<const inotify_event*>(buffer.data() + at);
      at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
      const auto folder = names_.find(event->wd);
      if (event->len > 0 && folder != names_.end() && folder->second.contains(event->name))
        changed.insert(event->name);
    }
  }
  return changed;
}

}  // namespace flexkey::cli
