#include "flexkey/preview/images/sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace flexkey {
namespace {

std::string replaced(const std::string& text, char from, std::string_view to) {
  std::string result;
  for (const char c : text) {
    if (c == from)
      result += to;
    else
      result += c;
  }
  return result;
}

/// As one word of a POSIX shell.
std::string shell_word(const std::string& text) {
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) ||
           std::string_view("%_-./+=:,").find(c) != std::string_view::npos;
  });
  return plain ? text : fmt::format("'{}'", replaced(text, '\'', "'\\''"));
}

/// The steps between the frames where they are all equal, else 0.
int common_step(std::span<const int> frames) {
  const int step = frames.size() < 2 ? 1 : frames[1] - frames[0];
  for (std::size_t i = 1; i < frames.size(); ++i)
    if (frames[i] - frames[i - 1] != step) return 0;
  return step;
}

/// What ffmpeg is to read. Numbers that do not follow each other can only be taken as all that match.
std::string input_of(const PictureSequence& sequence, std::span<const int> frames) {
  const std::string folder = sequence.folder.lexically_normal().string();
  const std::string_view extension = name_of(sequence.format);
  const auto word = [&](const std::string& in, std::string_view pattern) {
    return shell_word((std::filesystem::path(in) / fmt::format("{}.{}", pattern, extension)).string());
  };
  if (common_step(frames) != 1) return fmt::format("-pattern_type glob -i {}", word(folder, "*"));
  const std::string start = frames.front() == 0 ? "" : fmt::format("-start_number {} ", frames.front());
  return fmt::format("{}-i {}", start, word(replaced(folder, '%', "%%"), "%04d"));
}

}  // namespace

std::filesystem::path frame_path(const PictureSequence& sequence, int frame) {
  return sequence.folder / fmt::format("{:04}.{}", frame, name_of(sequence.format));
}

std::string ffmpeg_line(const PictureSequence& sequence, std::span<const int> frames, double fps) {
  const double rate = fps / std::max(1, common_step(frames));
  const std::string linear = sequence.format == ImageFormat::exr ? "-apply_trc iec61966_2_1 " : "";
  std::filesystem::path film = (sequence.folder / ".").lexically_normal().parent_path();
  film += ".mp4";
  return fmt::format("ffmpeg -framerate {:.6g} {}{} -vf {} -c:v libx264 -crf 18 -pix_fmt yuv420p {}", rate,
                     linear, input_of(sequence, frames), "'pad=ceil(iw/2)*2:ceil(ih/2)*2'",
                     shell_word(film.string()));
}

}  // namespace flexkey
