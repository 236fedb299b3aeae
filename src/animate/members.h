#pragma once

#include <tuple>

#include "flexkey/animate/handle_states.h"
#include "flexkey/animate/scene.h"
#include "flexkey/mesh/members.h"

namespace flexkey {

// The members of the values that a shot's state is saved and recognised by; see mesh/members.h.

template <MaybeConst<AxisAngle> Self>
auto members_of(Self& turn) {
  auto& [axis, angle] = turn;
  return std::tie(axis, angle);
}

template <MaybeConst<HandleMotion> Self>
auto members_of(Self& motion) {
  auto& [scale, rotation, further, move] = motion;
  return std::tie(scale, rotation, further, move);
}

template <MaybeConst<HandleStates> Self>
auto members_of(Self& states) {
  auto& [motions, curves] = states;
  return std::tie(motions, curves);
}

template <MaybeConst<Constraints> Self>
auto members_of(Self& constraints) {
  auto& [handles, region, owner, strengths, rigid] = constraints;
  return std::tie(handles, region, owner, strengths, rigid);
}

template <MaybeConst<Rider> Self>
auto members_of(Self& rider) {
  auto& [vertices, carriers] = rider;
  return std::tie(vertices, carriers);
}

template <MaybeConst<SolverSettings> Self>
auto members_of(Self& solver) {
  auto& [preset, system, local_scale, epsilon, weights, cell, area_weighting, iterations, tolerance, predict,
         accelerate, max_step] = solver;
  return std::tie(preset, system, local_scale, epsilon, weights, cell, area_weighting, iterations, tolerance,
                  predict, accelerate, max_step);
}

}  // namespace flexkey
