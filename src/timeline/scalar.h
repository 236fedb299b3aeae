#pragma once

#include <optional>
#include <string_view>

#include "flexkey/timeline/scope.h"

namespace flexkey {

// Each reads one value; nothing, and a finding at its place, if the text says something else.

std::optional<double> read_number(const Node& node, Scope& scope);
std::optional<int> read_whole(const Node& node, Scope& scope);

/// A time within 1e-6 of a frame as that frame's, k / fps to the bit.
double snapped_to_frame(double time, double fps);

/// Seconds of "1.5", "1.5s" or "36f"; may be negative.
std::optional<double> parse_plain_time(std::string_view text, double fps);

/// Seconds, at or after 0: "1.5", "1.5s", "36f", "hit", "hit+4f". A time within 1e-6 of a frame is that
/// frame's time k / fps to the bit, so that a sample at the frame meets the key.
std::optional<double> read_time(const Node& node, Scope& scope);

/// Radians; the unit must be there: "90deg", "1.57rad".
std::optional<double> read_angle(const Node& node, Scope& scope);

/// Mesh units, or with % a share.
std::optional<Length> read_length(const Node& node, Scope& scope);
/// A length at or above 0.
std::optional<Length> read_distance(const Node& node, Scope& scope);

/// Above 0: a share of the diagonal as a plain number, or with %.
std::optional<double> read_tolerance(const Node& node, Scope& scope);

/// "on", "true" or "yes", and their contraries.
std::optional<bool> read_switch(const Node& node, Scope& scope);

}  // namespace flexkey
