#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>

#include "flexkey/mesh/limits.h"
#include "flexkey/timeline/parse.h"

namespace flexkey {
namespace {

[[noreturn]] void throw_unreadable(const std::string& file, const std::string& reason) {
  throw TimelineError(file, {{Diagnostic::Severity::error, {}, "cannot be read: " + reason}});
}

/// At most one byte more than a timeline may have, so that an endless stream ends in an error.
std::string read_bounded(std::istream& stream) {
  std::string text(limits::timeline_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

std::string read_stream(std::istream& stream, const std::string& file) {
  std::string text = read_bounded(stream);
  if (stream.bad()) throw_unreadable(file, "reading failed");
  if (text.size() > limits::timeline_bytes)
    throw_unreadable(file, fmt::format("it is larger than {} MiB", limits::timeline_bytes >> 20));
  return text;
}

}  // namespace

std::string read_timeline(const std::string& file) {
  if (file == "-") return read_stream(std::cin, file);
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw_unreadable(file, "it is a folder");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw_unreadable(file, std::generic_category().message(errno));
  return read_stream(stream, file);
}

}  // namespace flexkey
