#pragma once

#include <filesystem>
#include <map>

#include "flexkey/animate/clip.h"
#include "flexkey/preview/images/spool.h"

namespace flexkey::cli {

/// A solved frame that outlives its solve.
struct KeptFrame {
  FrameReport report;
  Positions positions;  // as SolvedFrame has them
};

/// The solved frames of a run on disk, in a file without a name, so that memory does not grow with them.
class FrameSpool {
 public:
  /// In the folder of `beside`, for meshes of this many vertices. Failures are OutputErrors.
  FrameSpool(const std::filesystem::path& beside, int vertex_count);

  void add(const SolvedFrame& frame);
  KeptFrame frame(int number) const;  // one that was added

 private:
  struct Place {
    std::size_t block;
    FrameReport report;
  };
  int vertex_count_;
  Spool spool_;
  std::map<int, Place> places_;  // by the frame's number
};

}  // namespace flexkey::cli
