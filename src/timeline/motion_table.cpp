#include "flexkey/timeline/motion_table.h"

#include <fmt/format.h>

#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "flexkey/mesh/spelling.h"
#include "flexkey/timeline/number.h"
#include "flexkey/timeline/rotation.h"
#include "flexkey/timeline/table_lines.h"

namespace flexkey {
namespace {

using Words = std::vector<std::string_view>;

enum Column { time, tx, ty, tz, rx, ry, rz, qx, qy, qz, qw, column_count };
const std::vector<std::string> column_names{"time", "tx", "ty", "tz", "rx", "ry",
                                            "rz",   "qx", "qy", "qz", "qw"};

/// Which column each word of a line is of.
using Layout = std::vector<Column>;

bool is_header(const Words& words) {
  return !parse_number(words.front());
}

Layout named_layout(int line, const Words& words) {
  Layout layout;
  for (const std::string_view word : words) {
    const auto found = std::find(column_names.begin(), column_names.end(), word);
    if (found == column_names.end()) {
      const std::string near = nearest_word(std::string(word), column_names);
      throw InputError(fmt::format("line {}: unknown column '{}'{}", line, word,
                                   near.empty() ? "; known are time, tx, ty, tz, rx, ry, rz, qx, qy, qz, qw"
                                                : fmt::format("; did you mean '{}'?", near)));
    }
    layout.push_back(static_cast<Column>(found - column_names.begin()));
  }
  if (std::find(layout.begin(), layout.end(), time) == layout.end())
    throw InputError(fmt::format("line {}: there is no column 'time'", line));
  return layout;
}

Layout layout_of_size(int line, std::size_t size) {
  if (size == 4) return {time, tx, ty, tz};
  if (size == 7) return {time, tx, ty, tz, rx, ry, rz};
  if (size == 8) return {time, tx, ty, tz, qx, qy, qz, qw};
  throw InputError(
      fmt::format("line {}: {} numbers; 4 are a time and an offset, 7 have angles and 8 a quaternion "
                  "beside them",
                  line, size));
}

MotionSample sample_of(int line, const Words& words, const Layout& layout) {
  if (words.size() != layout.size())
    throw InputError(fmt::format("line {}: {} numbers, where {} belong", line, words.size(), layout.size()));
  std::array<double, column_count> values{};
  values[qw] = std::find(layout.begin(), layout.end(), qw) == layout.end() ? 1 : 0;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::optional<double> number = parse_number(words[k]);
    if (!number) throw InputError(fmt::format("line {}: {}", line, number_problem(words[k])));
    values[layout[k]] = *number;
  }
  const auto turn = [&](Column angle, int axis) {
    return Eigen::AngleAxisd(values[angle] / 180 * std::numbers::pi, Vec3::Unit(axis));
  };
  const Eigen::Quaterniond by_angles = turn(rz, 2) * turn(ry, 1) * turn(rx, 0);
  const Eigen::Quaterniond given(values[qw], values[qx], values[qy], values[qz]);
  if (given.norm() == 0)
    throw InputError(fmt::format("line {}: the quaternion 0 0 0 0 is no rotation", line));
  return {values[time], {values[tx], values[ty], values[tz]}, by_angles * given.normalized()};
}

}  // namespace

MotionTracks motion_of_table(std::string_view text) {
  Layout layout;
  std::vector<MotionSample> samples;
  for_each_line(text, [&](int line, const Words& words) {
    if (layout.empty() && is_header(words)) {
      layout = named_layout(line, words);
      return;
    }
    if (layout.empty()) layout = layout_of_size(line, words.size());
    const MotionSample sample = sample_of(line, words, layout);
    if (sample.time < 0 || (!samples.empty() && sample.time <= samples.back().time))
      throw InputError(
          fmt::format("line {}: the time {} {}", line, number_text(sample.time),
                      sample.time < 0 ? "is below 0" : "does not come after that of the line before"));
    samples.push_back(sample);
  });
  if (samples.empty()) throw InputError("it has no line of numbers");
  return relative_tracks(samples);
}

MotionTracks relative_tracks(const std::vector<MotionSample>& samples) {
  MotionTracks tracks;
  Eigen::Vector4d last(1, 0, 0, 0);
  for (const MotionSample& sample : samples) {
    const Eigen::Quaterniond turn = sample.rotation * samples.front().rotation.conjugate();
    Eigen::Vector4d quaternion(turn.w(), turn.x(), turn.y(), turn.z());
    if (quaternion.dot(last) < 0) quaternion = -quaternion;  // the nearer of the two that mean this rotation
    last = quaternion;
    tracks.move.push_back({sample.time, sample.move - samples.front().move, {}});
    tracks.rotate.push_back({sample.time, axis_angle_of(quaternion), {}});
    tracks.scale.push_back({sample.time, sample.scale.cwiseQuotient(samples.front().scale), {}});
  }
  return tracks;
}

}  // namespace flexkey
