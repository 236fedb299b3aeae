#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flexkey/animate/frame_log.h"
#include "flexkey/animate/take.h"
#include "flexkey/animate/waypoint.h"

namespace flexkey {

/// What is solved of a take, in a folder of its own: `frames`, a FrameLog, and `checkpoint`, a waypoint from
/// which a stopped solve goes on to the same bytes. What was solved from other inputs, or is damaged, is not
/// taken. Frames here are those that are solved, one a step of the shot (see timeline/steps.h).
class TakeState {
 public:
  /// Looks at what is there of the take, which outlives it. program: see inputs_of. wanted: frames of the
  /// shot whose positions must be sound, increasing; empty: all.
  TakeState(std::filesystem::path folder, const Take& take, std::string_view program,
            const std::vector<int>& wanted = {});

  /// How many frames are there, from frame 0 on, of these inputs.
  int frames() const { return frames_; }
  /// Of one of them.
  const FrameReport& report(int frame) const { return log_.frames()[static_cast<std::size_t>(frame)].report; }
  /// Likewise, #V x 3, vertices in the file's order, file units. From several threads, also while a further
  /// frame is added. Throws StateError if they are damaged.
  Positions positions(int frame) const { return log_.positions(frame); }
  /// What keeps frames that are there from being taken, such as "the mesh has changed"; empty: nothing.
  const std::string& fault() const { return fault_; }

  /// Whether they are all that is wanted.
  bool is_complete() const { return frames_ >= wanted_; }
  /// The frame from which a solve goes on.
  int next() const { return is_complete() ? wanted_ : next_; }
  const std::filesystem::path& folder() const { return folder_; }

  /// Where the solve goes on, at most behind the frames that are there; nothing: at rest. Throws DeformError
  /// if the surface cannot be solved, ArchiveError for what was only made to look like a checkpoint.
  std::optional<Waypoint> waypoint(DeformerCache& cache) const;

  /// Adds a frame, in place of those that are there from its number on. Throws OutputError.
  void add(const FrameReport& report, const Positions& positions);
  /// Whether enough was solved since the last checkpoint for it to be worth another.
  bool wants_checkpoint() const;
  /// After frames were added; without any, what is there stays. Throws OutputError.
  void save_checkpoint(const Waypoint& waypoint);
  /// Removes what is there, as where the disk is full and outputs need the room.
  void remove();

 private:
  using Clock = std::chrono::steady_clock;
  std::filesystem::path checkpoint_path() const { return folder_ / "checkpoint"; }
  void compare();
  void verify(const std::vector<int>& wanted);
  void find_checkpoint();
  void prepare_folder() const;
  Digest motion_before(int frame) const;

  std::filesystem::path folder_;
  Take take_;
  SolveInputs inputs_;
  FrameLog log_;
  int wanted_;            // how many frames from frame 0 on
  int frames_ = 0;        // that are there
  int next_ = 0;          // of the checkpoint
  bool is_open_ = false;  // to add frames
  std::string fault_;
  Clock::time_point saved_ = Clock::now();
  Clock::duration cost_{};  // of the last checkpoint
};

}  // namespace flexkey
