#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "flexkey/mesh/mesh.h"

namespace flexkey {

/// What the solver says of one frame.
struct FrameReport {
  int frame = 0;      // k; its time is k / fps
  double lambda = 0;  // λ of the frame, 0 smooth .. 1 rigid
  int solves = 0;     // global solves spent
  double estimate =
      0;  // of the distance to the converged answer, a share of the rest diagonal; infinite: unknown
  bool converged = false;
  bool slipped = false;  // the surface has lost a turn that its handles made
};

/// A solved frame as it comes, for what is written on the way; good for the length of a call.
struct SolvedFrame {
  const FrameReport& report;
  const Positions& positions;                // #V x 3, vertices in the file's order, file units
  std::span<const Eigen::Matrix4d> handles;  // #handles, rest to frame: a point at rest goes to M [x y z 1]ᵀ
};

/// A solved animation: what every exporter and the preview read.
struct Clip {
  std::string name;                  // the shot's
  Mesh mesh;                         // the rest mesh as its file has it
  double fps = 24;                   // frames a second
  std::vector<Positions> frames;     // #frames of #V x 3, vertices in the file's order, file units
  std::vector<FrameReport> reports;  // #frames
  int period = 0;             // of a cycle: its number of frames, that of the one which is frame 0 again
  std::optional<double> gap;  // of a cycle that was solved to its end: the farthest that a vertex is
                              // there from where it was in frame 0, a share of the rest diagonal
};

/// Whether a clip has all frames of a cycle, so that it comes round.
inline bool comes_round(const Clip& clip) {
  return clip.period > 0 && static_cast<int>(clip.reports.size()) == clip.period;
}

}  // namespace flexkey
