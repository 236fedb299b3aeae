#include "solves.h"

#include <algorithm>

#include "flexkey/animate/animate.h"
#include "flexkey/mesh/read_mesh.h"
#include "flexkey/timeline/parse.h"

namespace flexkey::bench {
namespace {

DeformOptions options_of(const Setting& setting, Start start) {
  DeformOptions options{.system = setting.system, .local_scale = setting.local_scale};
  if (start == Start::predicted) return options;
  options.predict = false;
  options.accelerate = start == Start::accelerated;
  options.iterations = 200;
  return options;
}

/// The frame as the deformer wants it: a turn is news only to one that predicts.
Targets seen_by(const Targets& targets, Start start) {
  return start == Start::predicted ? targets : Targets(targets.positions);
}

}  // namespace

std::vector<Setting> all_settings() {
  std::vector<Setting> settings;
  for (const LocalScale local_scale : {LocalScale::uniform, LocalScale::axis}) {
    for (const System system : {System::least_squares, System::direct}) {
      for (const double lambda : {0.0, 0.2, 0.5, 0.8}) settings.push_back({system, local_scale, lambda});
      if (local_scale == LocalScale::uniform) settings.push_back({system, local_scale, 1});
    }
  }
  return settings;
}

Tally& Tally::operator+=(const Tally& other) {
  frames += other.frames;
  solves += other.solves;
  converged += other.converged;
  return *this;
}

Honesty& Honesty::operator+=(const Honesty& other) {
  claimed += other.claimed;
  checked += other.checked;
  unsettled += other.unsettled;
  beyond += other.beyond;
  worst = std::max(worst, other.worst);
  return *this;
}

Tally count_solves(const Motion& motion, const Setting& setting, Start start) {
  const Deformer deformer(motion.mesh, motion.constraints, options_of(setting, start));
  Tally tally;
  Pose pose = deformer.rest_pose();
  for (const Targets& targets : motion.frames) {
    if (start == Start::cold) pose = deformer.rest_pose();
    const SolveReport report = deformer.solve(seen_by(targets, start), setting.lambda, pose);
    tally += {1, report.solves, report.converged ? 1 : 0};
  }
  return tally;
}

Tally count_shot(const std::filesystem::path& timeline) {
  const Shot shot = parse_shot(read_timeline(timeline), timeline).shot;
  const Clip clip = animate(shot, read_mesh(timeline.parent_path() / shot.mesh.file).mesh);
  Tally tally;
  for (const FrameReport& report : clip.reports) {
    if (report.solves > 0) tally += {1, report.solves, report.converged ? 1 : 0};
  }
  return tally;
}

Honesty check_honesty(const Motion& motion, const Setting& setting) {
  constexpr std::size_t most_checked = 12;
  const DeformOptions options = options_of(setting, Start::predicted);
  const Deformer deformer(motion.mesh, motion.constraints, options);
  DeformOptions on = options_of(setting, Start::accelerated);
  on.tolerance = 1e-9;
  on.iterations = 1000;
  const Deformer to_the_end(motion.mesh, motion.constraints, on);
  const double diagonal = bounds_of(motion.mesh.positions).diagonal();
  const std::size_t stride = (motion.frames.size() + most_checked - 1) / most_checked;

  Honesty honesty;
  Pose pose = deformer.rest_pose();
  for (std::size_t frame = 0; frame < motion.frames.size(); ++frame) {
    if (!deformer.solve(motion.frames[frame], setting.lambda, pose).converged) continue;
    ++honesty.claimed;
    if ((frame + 1) % stride != 0) continue;
    Pose end = pose;
    end.converged = false;  // or the solver would hand it back as this frame's answer
    const bool settled = to_the_end.solve(motion.frames[frame].positions, setting.lambda, end).converged;
    const double distance = (end.positions - pose.positions).rowwise().norm().maxCoeff() / diagonal;
    honesty += {0, 1, settled ? 0 : 1, distance > 2 * options.tolerance ? 1 : 0, distance};
  }
  return honesty;
}

}  // namespace flexkey::bench
