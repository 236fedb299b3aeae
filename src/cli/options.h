#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "flexkey/mesh/error.h"
#include "flexkey/timeline/parse.h"

namespace flexkey::cli {

/// A command line that makes no sense (exit code 2).
class UsageError : public Error {
 public:
  using Error::Error;
};

/// A part of a sweep's runs, or of a shot's frames.
struct Chunk {
  std::size_t number = 1;  // from 1
  std::size_t of = 1;
};

/// The flags that the commands on a shot share.
struct ShotOptions {
  std::string shot;                     // a path, or "-" for standard input
  std::filesystem::path out_dir = ".";  // where relative output paths go
  std::vector<std::string> set;         // key.path=value
  std::string frames;                   // "0-30,47,60-90x2", or empty for all
  int threads = 0;                      // 0: SLURM_CPUS_PER_TASK, else all cores
  bool json = false;
  bool quiet = false;
  bool strict = false;
  std::filesystem::path picture;  // that `check` draws, from the outputs' folder; empty: none
  bool no_solve = false;          // refuse where the shot's state is missing or stale
  std::optional<Chunk> chunk;     // of the shot's sweep
  std::optional<Chunk> part;      // of the frames

  /// `set`, split at the first '='. Throws UsageError.
  std::vector<Override> overrides() const;
};

/// "0-30,47,60-90x2" as increasing frame numbers, all below frame_count. Throws UsageError.
std::vector<int> parse_frames(const std::string& text, int frame_count);

/// "2/4", the second of four parts. Throws UsageError.
Chunk parse_chunk(const std::string& text);

/// Where the chunk of so many things in a row begins, and where it ends. Throws UsageError if it has none of
/// them.
std::pair<std::ptrdiff_t, std::ptrdiff_t> range_of(const Chunk& chunk, std::size_t count,
                                                   std::string_view thing);

/// Threads to use: `asked` if positive, else SLURM_CPUS_PER_TASK, else every core.
int thread_count(int asked);

}  // namespace flexkey::cli
