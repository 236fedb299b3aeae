#pragma once

#include <optional>
#include <vector>

#include "gltf.h"
#include "limit.h"
#include "peers.h"
#include "preview.h"
#include "study.h"
#include "table.h"

namespace flexkey::bench {

/// Wall-clock seconds of one iteration.
struct ThreadTimes {
  int vertices = 0;
  std::vector<double> one = {}, two = {};  // an entry a repetition
};

/// All that a run has measured; what it was not asked for is empty.
struct Results {
  std::vector<PeerResult> peers;
  std::optional<ThreadTimes> threads;
  std::optional<Limit> limit;
  std::optional<Study> study;
  std::vector<GltfResult> gltf;
  std::optional<PreviewResult> preview;
};

Table peer_table(const std::vector<PeerResult>& peers);
Table thread_table(const ThreadTimes& threads);
Table limit_table(const Limit& limit);
/// Solves a frame by start, of the bar's five scenes together and of the blob.
Table start_table(const Study& study);
/// Solves a frame by scene with the default start.
Table scene_table(const Study& study);
Table shot_table(const Study& study);
Table honesty_table(const Study& study);

/// Targets, bytes and errors of the sample clips' files.
Table gltf_table(const std::vector<GltfResult>& results);
Table gltfpack_table(const std::vector<GltfResult>& results);

Table preview_table(const PreviewResult& result);
/// Medians of the rounds' own ratios: stencils to refining, and geometry's share of a frame.
double stencil_ratio(const StencilTimes& times);
double geometry_share(const FrameTimes& times);

/// What flexkey has set itself to reach, beside what was measured.
Table bar_table(const Results& results);

std::vector<Table> all_tables(const Results& results);

}  // namespace flexkey::bench
