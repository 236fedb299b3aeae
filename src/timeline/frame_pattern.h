#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace flexkey {

/// How often a pattern such as "frames/%04d.obj" names the frame's number: as "%d" or, with zeros in front up
/// to a width of 1 to 9, "%04d"; "%%" is a percent sign. Nothing where another sign follows a percent sign.
std::optional<int> count_frame_numbers(std::string_view pattern);

/// The path of frame k. The pattern is one of which count_frame_numbers knows the count.
std::string frame_path(std::string_view pattern, int frame);

}  // namespace flexkey
