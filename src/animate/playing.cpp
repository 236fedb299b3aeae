#include "flexkey/animate/playing.h"

#include <algorithm>
#include <utility>

#include "flexkey/animate/handle_matrices.h"
#include "flexkey/timeline/steps.h"

namespace flexkey {
namespace {

/// Passes a wanted frame on and keeps what is to be kept of it.
void pass_on(Running& run, std::size_t take, PassingStep frame, const AnimateHooks& hooks) {
  if (hooks.on_wanted) {
    const double time = time_of_frame(run.take.shot, frame.report.frame);
    hooks.on_wanted(take, {frame.report, frame.positions, handle_matrices(run.take.scene, time)});
  }
  if (hooks.keep == Keep::frames) run.clip.frames.push_back(std::move(frame.positions));
  run.clip.reports.push_back(frame.report);
}

bool is_stored(const Running& run, int step) {
  return run.take.before != nullptr && run.take.before->frames() > step;
}

/// Where frame 0 of a cycle is, or its end.
bool shows_gap(const Running& run, int step, const Audience& audience) {
  const bool is_turn = step == run.clip.period || step == 2 * run.clip.period;
  return run.clip.period > 0 && audience.wanted.empty() && is_turn;
}

void note_gap(Running& run, int step, const Positions& positions) {
  if (step == run.clip.period) {
    run.held_back[step] = positions;
    return;
  }
  const Positions offsets = positions - run.held_back.at(run.clip.period);
  run.clip.gap =
      offsets.rowwise().norm().maxCoeff() / bounds_of(run.take.scene.weld.surface.positions).diagonal();
}

}  // namespace

bool Audience::wants(int frame) const {
  return wanted.empty() || std::binary_search(wanted.begin(), wanted.end(), frame);
}

bool needs_positions(const Running& run, int step, const Audience& audience) {
  const std::optional<int> frame = frame_of(run.take.shot, step);
  const bool comes_again = run.take.shot.loop == Loop::ping_pong && !is_stored(run, step);
  return comes_again || shows_gap(run, step, audience) || (frame && audience.wants(*frame));
}

void deliver(Running& run, std::size_t take, PassingStep step, const Audience& audience) {
  const int number = step.report.frame;
  const std::optional<int> frame = frame_of(run.take.shot, number);
  run.reports.push_back(step.report);
  if (shows_gap(run, number, audience)) note_gap(run, number, step.positions);
  if (run.take.shot.loop == Loop::ping_pong && !is_stored(run, number))
    run.held_back[number] = step.positions;
  step.report.frame = number - run.clip.period;
  if (frame && audience.wants(*frame)) pass_on(run, take, step, audience.hooks);
  if (audience.hooks.on_frame) audience.hooks.on_frame(take, step.report);
}

void deliver_way_back(Running& run, std::size_t take, const Audience& audience) {
  const Shot& shot = run.take.shot;
  const bool is_whole = static_cast<int>(run.reports.size()) >= run.count;
  if (shot.loop != Loop::ping_pong || !is_whole) return;
  for (int frame = step_count(shot); frame < shot.frame_count(); ++frame) {
    if (!audience.wants(frame)) continue;
    if (audience.hooks.stop && audience.hooks.stop()) return;
    const int step = step_of(shot, frame);
    PassingStep again{run.reports[static_cast<std::size_t>(step)], {}};
    again.report.frame = frame;
    const auto held = run.held_back.find(step);
    if (held == run.held_back.end() && !is_stored(run, step))
      throw OutputError("cannot play the frames backwards: the state that had them is gone");
    again.positions =
        held != run.held_back.end() ? std::move(held->second) : run.take.before->positions(step);
    pass_on(run, take, std::move(again), audience.hooks);
  }
}

}  // namespace flexkey
