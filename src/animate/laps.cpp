#include "flexkey/animate/laps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "flexkey/timeline/steps.h"

namespace flexkey {
namespace {

double whole_turns(double from, double to) {
  constexpr double turn = 2 * std::numbers::pi;
  return turn * std::round((to - from) / turn);
}

}  // namespace

std::vector<std::vector<double>> turns_to_unwind(const Take& take, int step) {
  const int lap = take.shot.frame_count();
  if (take.shot.loop != Loop::cycle || step != lap) return {};
  const HandleStates start = sample_states(take.scene, 0);
  const HandleStates end = sample_states(take.scene, time_of_step(take.shot, 2 * lap));
  std::vector<std::vector<double>> turns;
  for (std::size_t h = 0; h < start.motions.size(); ++h) {
    const HandleMotion &from = start.motions[h], &to = end.motions[h];
    std::vector<double>& own = turns.emplace_back();
    own.push_back(whole_turns(from.rotation.angle, to.rotation.angle));
    for (std::size_t k = 0; k < std::min(from.further.size(), to.further.size()); ++k)
      own.push_back(whole_turns(from.further[k].angle, to.further[k].angle));
  }
  return turns;
}

HandleStates unwound(HandleStates states, const std::vector<std::vector<double>>& turns) {
  for (std::size_t h = 0; h < turns.size(); ++h) {
    HandleMotion& motion = states.motions[h];
    motion.rotation.angle -= turns[h][0];
    for (std::size_t k = 1; k < std::min(turns[h].size(), motion.further.size() + 1); ++k)
      motion.further[k - 1].angle -= turns[h][k];
  }
  return states;
}

}  // namespace flexkey
