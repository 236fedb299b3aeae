#include "flexkey/timeline/cues.h"

#include <fmt/format.h>

#include <optional>

#include "flexkey/timeline/number.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/table_lines.h"

namespace flexkey {

std::vector<Cue> cues_of(std::string_view text, double fps) {
  std::vector<Cue> cues;
  for_each_line(text, [&](int line, const std::vector<std::string_view>& words) {
    if (words.size() != 2)
      throw InputError(
          fmt::format("line {}: a time and a name belong on a line, not {} words", line, words.size()));
    const std::optional<double> time = parse_plain_time(words[0], fps);
    if (!time || *time < 0)
      throw InputError(fmt::format("line {}: '{}' is not a time; times are seconds (1.5s) or frames (36f)",
                                   line, words[0]));
    const double snapped = snapped_to_frame(*time, fps);
    if (!cues.empty() && snapped <= cues.back().time)
      throw InputError(
          fmt::format("line {}: the time {} does not come after that of the line before", line, words[0]));
    cues.push_back({snapped, std::string(words[1])});
  });
  if (cues.empty()) throw InputError("it has no line with a time and a name");
  return cues;
}

}  // namespace flexkey
