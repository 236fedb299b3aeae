#include "cli/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <thread>

#include "flexkey/timeline/frame_ranges.h"
#include "flexkey/timeline/number.h"

namespace flexkey::cli {

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
  std::vector<FrameRange> ranges;
  std::string_view left = text;
  while (!left.empty()) {
    const std::size_t comma = left.find(',');
    const std::string_view part = left.substr(0, comma);
    left = comma == std::string_view::npos ? std::string_view() : left.substr(comma + 1);

    const std::optional<FrameRange> range = parse_frame_range(part);
    if (!range) refuse(part, "is not a frame, a range 0-30 or a stepped range 60-90x2");
    if (range->last >= frame_count)
      refuse(part, fmt::format("is past the shot's last frame, {}", frame_count - 1));
    ranges.push_back(*range);
  }
  return frames_in(ranges);
}

Chunk parse_chunk(const std::string& text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const int number = parse_whole(text.substr(0, slash)).value_or(0);
  const int of = slash < text.size() ? parse_whole(text.substr(slash + 1)).value_or(0) : 0;
  if (number < 1 || of < number)
    throw UsageError(
        fmt::format("--chunk '{}' is not of the form i/n with i from 1 to n, such as 2/4", text));
  return {static_cast<std::size_t>(number), static_cast<std::size_t>(of)};
}

std::pair<std::ptrdiff_t, std::ptrdiff_t> range_of(const Chunk& chunk, std::size_t count,
                                                   std::string_view thing) {
  const std::size_t first = count * (chunk.number - 1) / chunk.of, last = count * chunk.number / chunk.of;
  if (first == last)
    throw UsageError(fmt::format("--chunk {}/{}: there is no {} in it; there are {}", chunk.number, chunk.of,
                                 thing, count));
  return {static_cast<std::ptrdiff_t>(first), static_cast<std::ptrdiff_t>(last)};
}

int thread_count(int asked) {
  if (asked > 0) return asked;
  if (const char* slurm = std::getenv("SLURM_CPUS_PER_TASK"))
    if (const int count = parse_whole(slurm).value_or(0); count > 0) return count;
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

}  // namespace flexkey::cli
