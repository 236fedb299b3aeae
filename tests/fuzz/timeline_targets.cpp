#include "flexkey/animate/animate.h"
#include "flexkey/animate/deform_options.h"
#include "flexkey/mesh/limits.h"
#include "flexkey/timeline/cues.h"
#include "flexkey/timeline/motion_table.h"
#include "flexkey/timeline/parse.h"
#include "fuzz/targets.h"
#include "support/meshes.h"

namespace flexkey::fuzz {
namespace {

/// Files that every name stands for, so that what reads them is reached.
Sources sources() {
  Sources any;
  any.text = [](const std::string& path) -> std::string {
    if (path.ends_with(".csv")) return "0 0 0 0 0 0 0\n1 0 1 0 0 0 90\n";
    return "0 rest\n1 smile\n";
  };
  any.node_motion = [](const std::string&, const std::string&) {
    return relative_tracks({{}, {1, Vec3(0, 1, 0), Eigen::Quaterniond(0, 0, 0, 1), Vec3(1, 1, 1)}});
  };
  return any;
}

/// What is done with a shot before it is solved, on a small mesh.
void bind_and_sample(const Shot& shot) {
  static const Mesh mesh = meshes::bar(2, 2, 6);
  const Scene scene = bind_shot(shot, mesh);
  deform_options(shot.solver);
  const int last = shot.frame_count() - 1;
  for (const int frame : {0, 1, last / 2, last}) {
    const Positions targets = sample_targets(scene, frame / shot.fps);
    promise(targets.allFinite(), "finite targets");
  }
}

}  // namespace

void run_timeline(std::string_view bytes) {
  try {
    const ParsedShot parsed = parse_shot(bytes, "x.yaml", {}, sources());
    promise(parsed.shot.frame_count() >= 1 && parsed.shot.frame_count() <= limits::frames,
            "frames within the limits");
    for (const Shot& run : parsed.runs) preview_folder(run);
    bind_and_sample(parsed.shot);
  } catch (const Error&) {
    // Refused, as it may be.
  }
}

void run_cues(std::string_view bytes) {
  try {
    cues_of(bytes, 24);
  } catch (const Error&) {
    // Refused, as it may be.
  }
}

void run_table(std::string_view bytes) {
  try {
    for (const Key<Vec3>& key : motion_of_table(bytes).move) promise(key.value.allFinite(), "finite motions");
  } catch (const Error&) {
    // Refused, as it may be.
  }
}

}  // namespace flexkey::fuzz
