#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "flexkey/animate/animate.h"
#include "flexkey/animate/waypoint.h"

namespace flexkey {

/// A take on its way through its steps.
struct Running {
  const Take& take;
  int count = 0;               // of the steps to go through
  int taken = 0;               // of them, those that were solved before
  std::optional<Waypoint> at;  // none: no more are left to solve
  Clip clip;
  std::vector<FrameReport> reports = {};    // of the steps so far, by their own numbers
  std::map<int, Positions> held_back = {};  // of steps that are needed again and are kept nowhere else
};

/// Who hears of the frames.
struct Audience {
  const AnimateHooks& hooks;
  const std::vector<int>& wanted;  // frames, increasing; empty: all

  bool wants(int frame) const;
};

/// A step as it comes.
struct PassingStep {
  FrameReport report;   // its frame is the step's number
  Positions positions;  // none where they are not needed
};

bool needs_positions(const Running& run, int step, const Audience& audience);

/// Makes a frame of a step where one is wanted, and holds back what is needed again. Steps come one after
/// another.
void deliver(Running& run, std::size_t take, PassingStep step, const Audience& audience);

/// When all steps of a ping-pong shot have come: its later frames. Throws OutputError where what was kept of
/// the steps is gone.
void deliver_way_back(Running& run, std::size_t take, const Audience& audience);

}  // namespace flexkey
