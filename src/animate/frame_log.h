#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "flexkey/animate/clip.h"
#include "flexkey/animate/descriptor.h"
#include "flexkey/animate/solve_inputs.h"

namespace flexkey {

/// A frame of a state is damaged.
class StateError : public Error {
 public:
  using Error::Error;
};

/// What a frame's record says beside its positions.
struct LoggedFrame {
  FrameReport report;
  Digest motion;  // see motion_of
};

/// The solved frames of one take in one file: a head (name and version of the format, byte order, inputs),
/// then a record of one size a frame from frame 0 on, with its positions in double as they lie
/// in memory, each with checksums. Frames are only added at the end; what a stopped program left of a record
/// there is passed over, and overwritten by the next frame.
class FrameLog {
 public:
  /// Looks at what is there.
  FrameLog(std::filesystem::path path, const SolveInputs& inputs, Eigen::Index vertices);

  /// What the frames in the file were solved from; nothing where there is no file.
  const std::optional<SolveInputs>& solved_from() const { return solved_from_; }
  /// Why a file that is there cannot be read as a log; empty: it can.
  const std::string& fault() const { return fault_; }
  /// From frame 0 on, as far as records are whole.
  const std::vector<LoggedFrame>& frames() const { return frames_; }

  /// Of a frame that is there, #V x 3, vertices in the file's order. Throws StateError if they are damaged.
  /// May be called from several threads, also while another frame is added.
  Positions positions(int frame) const;

  /// Makes the file one of these inputs with its first `count` frames. Throws OutputError.
  void keep(int count);
  /// Adds the next frame, after `keep`. Throws OutputError, and leaves no part of it.
  void add(const LoggedFrame& frame, const Positions& positions);
  /// Gives back its room.
  void remove();
  /// Waits until the disk has all of it. Throws OutputError.
  void sync() const;

 private:
  void read_head();
  void read_frames();
  void write(std::span<const std::byte> bytes, std::uint64_t at) const;
  std::uint64_t place_of(std::size_t frame) const;
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  SolveInputs inputs_;
  Eigen::Index vertices_;
  Descriptor file_;
  std::optional<SolveInputs> solved_from_;
  std::string fault_;
  std::vector<LoggedFrame> frames_;
};

}  // namespace flexkey
