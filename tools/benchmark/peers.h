#pragma once

#include <string>
#include <vector>

namespace flexkey::bench {

/// One blob's size and how often it is measured: the short figures, and those of 60 frames.
struct Size {
  std::string name;
  int blob = 0;  // see make_blob
  int step_repetitions = 1;
  int clip_repetitions = 1;
};

/// Set-up and one iteration, CPU seconds of one thread, and the process's peak memory, bytes.
struct StepCost {
  double set_up = 0;
  double iteration = 0;
  double peak = 0;
};

/// 60 frames without the set-up, CPU seconds of one thread.
struct ClipCost {
  double seconds = 0;
  double solves = 0;     // a frame
  double converged = 0;  // share of the frames reported converged
};

/// Both libraries at one size; an entry a repetition.
struct PeerResult {
  Size size;
  int vertices = 0;
  std::vector<StepCost> cgal = {}, plain = {};  // flexkey: `direct`, λ = 1, plain iteration
  std::vector<StepCost> standard = {};  // flexkey, `direct`, λ = 0.8, all else by default; no iteration
  std::vector<ClipCost> cgal_2 = {}, cgal_5 = {};  // iterations a frame
  std::vector<ClipCost> plain_2 = {};              // likewise
  std::vector<ClipCost> converged = {};            // flexkey as in `standard`, to 1e-3 of the diagonal
  double difference = 0;  // of the answers after 2 iterations a frame, a share of the diagonal
};

PeerResult compare_with_peer(const Size& size);

/// Wall-clock seconds of one plain iteration of flexkey on that many threads.
double iteration_on_threads(int blob, int threads);

}  // namespace flexkey::bench
