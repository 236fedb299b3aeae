#pragma once

#include <vector>

#include "flexkey/animate/handle_states.h"
#include "flexkey/animate/take.h"

namespace flexkey {

/// The whole turns that each handle's keys make within a lap of a cycle, radians, before the step that begins
/// another lap; else empty. A handle that has gone from 0° to 360° goes on from 0°, and has not to turn back.
/// The handle's own angles one after another: `rotation`, then `further`.
std::vector<std::vector<double>> turns_to_unwind(const Take& take, int step);

/// The states with those turns taken back.
HandleStates unwound(HandleStates states, const std::vector<std::vector<double>>& turns);

}  // namespace flexkey
