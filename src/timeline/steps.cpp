#include "flexkey/timeline/steps.h"

#include <algorithm>

namespace flexkey {

int step_count(const Shot& shot) {
  const int frames = shot.frame_count();
  if (shot.loop == Loop::cycle) return 2 * frames + 1;
  return shot.loop == Loop::ping_pong ? frames / 2 + 1 : frames;
}

int step_of(const Shot& shot, int frame) {
  if (shot.loop == Loop::cycle) return shot.frame_count() + frame;
  const int last = step_count(shot) - 1;
  return frame <= last ? frame : 2 * last - frame;
}

std::optional<int> frame_of(const Shot& shot, int step) {
  if (shot.loop != Loop::cycle) return step;
  const int frame = step - shot.frame_count();
  return frame >= 0 && frame < shot.frame_count() ? std::optional(frame) : std::nullopt;
}

int steps_until(const Shot& shot, const std::vector<int>& frames) {
  if (frames.empty()) return step_count(shot);
  int last = 0;
  for (const int frame : frames) last = std::max(last, step_of(shot, frame));
  return last + 1;
}

std::vector<int> steps_shown(const Shot& shot, const std::vector<int>& frames) {
  std::vector<int> steps;
  for (const int frame : frames) steps.push_back(step_of(shot, frame));
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps;
}

double time_of_step(const Shot& shot, int step) {
  const int lap = shot.frame_count();
  return (shot.loop == Loop::cycle && step >= lap ? step - lap : step) / shot.fps;
}

double time_of_frame(const Shot& shot, int frame) {
  return time_of_step(shot, step_of(shot, frame));
}

double played_duration(const Shot& shot) {
  return shot.loop == Loop::ping_pong ? 2 * shot.duration : shot.duration;
}

}  // namespace flexkey
