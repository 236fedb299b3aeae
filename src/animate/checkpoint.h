#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "flexkey/animate/solve_inputs.h"
#include "flexkey/animate/waypoint.h"

namespace flexkey {

/// What a waypoint in a file belongs to.
struct CheckpointHead {
  SolveInputs inputs;
  Digest motion;  // of the frame before, see motion_of
  int next = 0;   // of the waypoint
};

/// A whole checkpoint file.
struct Checkpoint {
  CheckpointHead head;
  std::string file;                     // its bytes
  std::span<const std::byte> waypoint;  // those of them that load_waypoint takes
};

/// A file that is missing, damaged or of another format gives nothing.
std::unique_ptr<const Checkpoint> read_checkpoint(const std::filesystem::path& path);

/// Writes the name and version of the format, byte order, head, waypoint and a checksum, beside the file's
/// name, which it gets when whole. Throws OutputError.
void write_checkpoint(const std::filesystem::path& path, const CheckpointHead& head,
                      const Waypoint& waypoint);

}  // namespace flexkey
