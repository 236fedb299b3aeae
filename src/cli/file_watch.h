#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace flexkey::cli {

/// Tells when files change (inotify). The folders are watched and not the files, since an editor often writes
/// a new file and renames it over the old one.
class FileWatch {
 public:
  /// Throws Error where the system gives none.
  FileWatch();
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  /// Watches these files from now on and no others; those that are not there, too, where their folder is.
  /// What a link leads to is watched beside the link.
  void follow(const std::vector<std::filesystem::path>& files);

  /// To poll for reading.
  int descriptor() const { return descriptor_; }
  /// The names of the files that were written, made or removed since the last call; does not wait. A file
  /// that is only begun is not one of them.
  std::set<std::string> changed();

 private:
  int descriptor_;
  std::map<int, std::set<std::string>> names_;  // of each watched folder, by its number
};

}  // namespace flexkey::cli
