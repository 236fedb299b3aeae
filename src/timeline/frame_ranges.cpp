#include "flexkey/timeline/frame_ranges.h"

#include <charconv>
#include <set>

namespace flexkey {
namespace {

/// A whole number that fills all of `text`, or -1.
int whole_number(std::string_view text) {
  int value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value >= 0 ? value : -1;
}

}  // namespace

std::optional<FrameRange> parse_frame_range(std::string_view text) {
  const std::size_t times = text.find('x');
  const std::string_view range = text.substr(0, times);
  const std::size_t dash = range.find('-');
  FrameRange frames;
  frames.step = times == std::string_view::npos ? 1 : whole_number(text.substr(times + 1));
  frames.first = whole_number(range.substr(0, dash));
  frames.last = dash == std::string_view::npos ? frames.first : whole_number(range.substr(dash + 1));
  if (frames.first < 0 || frames.last < frames.first || frames.step < 1) return std::nullopt;
  return frames;
}

std::vector<int> frames_in(const std::vector<FrameRange>& ranges) {
  std::set<int> frames;
  for (const FrameRange& range : ranges)
    for (long frame = range.first; frame <= range.last; frame += range.step)
      frames.insert(static_cast<int>(frame));
  return {frames.begin(), frames.end()};
}

}  // namespace flexkey
