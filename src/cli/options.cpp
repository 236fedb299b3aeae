#include "cli/options.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <set>
#include <string_view>
#include <thread>

namespace flexkey::cli {
namespace {

/// A whole number that fills all of `text`, or -1.
int whole_number(std::string_view text) {
  int value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value >= 0 ? value : -1;
}

}  // namespace

std::vector<Override> ShotOptions::overrides() const {
  std::vector<Override> result;
  for (const std::string& text : set) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos)
      throw UsageError(fmt::format("--set '{}' is not of the form key.path=value", text));
    result.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  return result;
}

std::vector<int> parse_frames(const std::string& text, int frame_count) {
  const auto refuse = [&](std::string_view part, std::string_view why) {
    throw UsageError(fmt::format("--frames '{}': '{}' {}", text, part, why));
  };
  std::set<int> frames;
  std::string_view left = text;
  while (!left.empty()) {
    const std::size_t comma = left.find(',');
    const std::string_view part = left.substr(0, comma);
    left = comma == std::string_view::npos ? std::string_view() : left.substr(comma + 1);

    const std::size_t times = part.find('x');
    const std::string_view range = part.substr(0, times);
    const int step = times == std::string_view::npos ? 1 : whole_number(part.substr(times + 1));
    const std::size_t dash = range.find('-');
    const int first = whole_number(range.substr(0, dash));
    const int last = dash == std::string_view::npos ? first : whole_number(range.substr(dash + 1));
    if (first < 0 || last < first || step < 1)
      refuse(part, "is not a frame, a range 0-30 or a stepped range 60-90x2");
    if (last >= frame_count) refuse(part, fmt::format("is past the shot's last frame, {}", frame_count - 1));
    for (int frame = first; frame <= last; frame += step) frames.insert(frame);
  }
  return {frames.begin(), frames.end()};
}

int thread_count(int asked) {
  if (asked > 0) return asked;
  if (const char* slurm = std::getenv("SLURM_CPUS_PER_TASK"); slurm && whole_number(slurm) > 0)
    return whole_number(slurm);
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

}  // namespace flexkey::cli
