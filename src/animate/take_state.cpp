#include "flexkey/animate/take_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "flexkey/animate/checkpoint.h"
#include "flexkey/timeline/steps.h"

namespace flexkey {

TakeState::TakeState(std::filesystem::path folder, const Take& take, std::string_view program,
                     const std::vector<int>& wanted)
    : folder_(std::move(folder)),
      take_(take),
      inputs_(inputs_of(take, program)),
      log_(folder_ / "frames", inputs_, static_cast<Eigen::Index>(take.scene.weld.to_surface.size())),
      wanted_(steps_until(take.shot, wanted)) {
  compare();
  verify(steps_shown(take.shot, wanted));
  if (!is_complete()) find_checkpoint();
}

/// Counts the frames as far as they depend on what this take does.
void TakeState::compare() {
  fault_ = log_.solved_from() ? difference(*log_.solved_from(), inputs_) : log_.fault();
  const int count = std::min(static_cast<int>(log_.frames().size()), step_count(take_.shot));
  Digest motion;
  for (; frames_ < count; ++frames_) {
    motion = motion_of(take_, frames_, motion);
    if (motion == log_.frames()[static_cast<std::size_t>(frames_)].motion) continue;
    fault_ = fmt::format("the motion or lambda has changed from frame {} on", frames_);
    return;
  }
}

/// Counts no frame from the first damaged one on.
void TakeState::verify(const std::vector<int>& wanted) {
  for (int k = 0; k < frames_; ++k) {
    if (!wanted.empty() && !std::binary_search(wanted.begin(), wanted.end(), k)) continue;
    try {
      positions(k);
    } catch (const StateError& error) {
      fault_ = error.what();
      frames_ = k;
    }
  }
}

void TakeState::find_checkpoint() {
  std::error_code ignored;
  if (frames_ == 0 || !std::filesystem::exists(checkpoint_path(), ignored)) return;
  const std::unique_ptr<const Checkpoint> found = read_checkpoint(checkpoint_path());
  if (!found) {
    fault_ = "its checkpoint is damaged";
    return;
  }
  const CheckpointHead& head = found->head;
  const bool is_there = head.next > 0 && head.next <= frames_;
  if (head.inputs == inputs_ && is_there && head.motion == motion_before(head.next)) next_ = head.next;
}

std::optional<Waypoint> TakeState::waypoint(DeformerCache& cache) const {
  if (next_ == 0) return std::nullopt;
  const std::unique_ptr<const Checkpoint> found = read_checkpoint(checkpoint_path());
  if (!found) return std::nullopt;
  Waypoint waypoint = load_waypoint(found->waypoint, take_.scene, cache);
  if (waypoint.next != next_) throw ArchiveError("the checkpoint is not of the frame that it names");
  return waypoint;
}

void TakeState::add(const FrameReport& report, const Positions& positions) {
  if (!is_open_) {
    prepare_folder();
    log_.keep(report.frame);
    is_open_ = true;
  }
  log_.add({report, motion_of(take_, report.frame, motion_before(report.frame))}, positions);
  frames_ = report.frame + 1;
}

/// Makes it, and clears it of checkpoints whose writer was killed.
void TakeState::prepare_folder() const {
  std::error_code error, ignored;
  std::filesystem::create_directories(folder_, error);
  if (error)
    throw OutputError(fmt::format("cannot make the folder '{}': {}", folder_.string(), error.message()));
  for (const auto& entry : std::filesystem::directory_iterator(folder_, ignored))
    if (entry.path().filename().string().starts_with("checkpoint.part-"))
      std::filesystem::remove(entry.path(), ignored);
}

bool TakeState::wants_checkpoint() const {
  constexpr std::chrono::milliseconds least(250);
  constexpr int share = 40;  // of the time that the last one took
  return Clock::now() - saved_ >= std::max<Clock::duration>(least, share * cost_);
}

/// The frames reach the disk first, so that a checkpoint never stands behind frames that are lost.
void TakeState::save_checkpoint(const Waypoint& waypoint) {
  if (!is_open_) return;
  const Clock::time_point begin = Clock::now();
  log_.sync();
  write_checkpoint(checkpoint_path(), {inputs_, motion_before(waypoint.next), waypoint.next}, waypoint);
  saved_ = Clock::now();
  cost_ = saved_ - begin;
}

void TakeState::remove() {
  std::error_code ignored;  // what cannot be removed is not taken for whole either
  std::filesystem::remove(checkpoint_path(), ignored);
  log_.remove();
  frames_ = 0;
}

Digest TakeState::motion_before(int frame) const {
  return frame == 0 ? Digest{} : log_.frames()[static_cast<std::size_t>(frame) - 1].motion;
}

}  // namespace flexkey
