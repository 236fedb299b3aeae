#pragma once

#include <optional>
#include <string>

namespace flexkey {

/// What a frame's file says of itself.
struct PictureTags {
  std::string inputs;  // hash of all that the pixels depend on; letters and digits
  int frame = 0;
  double time = 0;  // seconds
  double lambda = 0;
};

/// As the one line that a file's metadata keeps: "flexkey inputs=6af1 frame=12 time=0.5 lambda=0.25".
std::string describe(const PictureTags& tags);

/// The tags of such a line; none if it is any other text.
std::optional<PictureTags> parse_tags(const std::string& line);

}  // namespace flexkey
