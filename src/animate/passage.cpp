#include "flexkey/animate/passage.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace flexkey {
namespace {

/// The way of the handles in one frame.
struct Way {
  HandleStates from, to;
  int parts = 1;

  HandleStates after(int part) const {
    if (part == parts) return to;
    return part == 0 ? from : blend(from, to, static_cast<double>(part) / parts);
  }
};

Way way_of(const Passage& passage, const Leg& leg) {
  Way way{passage.before, leg.now};
  for (const int h : leg.active) {
    const auto k = static_cast<std::size_t>(h);
    Positions &from = way.from.curves[k], &to = way.to.curves[k];
    const bool held = std::binary_search(passage.active.begin(), passage.active.end(), h);
    if (held && from.rows() == to.rows()) continue;
    // It takes hold, or fades at one end of the frame: each vertex goes from where it is.
    to = targets_of(leg.scene, leg.now, h);
    from = passage.pose.positions(leg.scene.handles[k].vertices, Eigen::all);
  }
  const Positions turns = turns_between(leg.scene, way.from, way.to)(leg.active, Eigen::all);
  const double largest = turns.rows() > 0 ? turns.rowwise().norm().maxCoeff() : 0;
  way.parts = std::max(1, static_cast<int>(std::ceil(largest / leg.max_step - 1e-9)));
  return way;
}

Frame part_of(const Way& way, const Leg& leg, int part) {
  const HandleStates before = way.after(part - 1), at = way.after(part);
  const Positions turns = turns_between(leg.scene, before, at);
  return {{targets_of(leg.scene, leg.active, at), turns(leg.active, Eigen::all)}, leg.lambda};
}

void hold_with(const ActiveSet& active, DeformerCache& cache, Passage& passage) {
  if (passage.active == active) return;
  passage.deformer = cache.of(active);
  passage.pose = passage.deformer->adopt(passage.pose);
  passage.active = active;
}

}  // namespace

Passage start_of(const Scene& scene, DeformerCache& cache) {
  Passage passage;
  passage.active = active_at(scene, 0);
  passage.deformer = cache.of(passage.active);
  passage.pose = passage.deformer->rest_pose();
  passage.before = rest_states(scene);
  return passage;
}

std::vector<SolveReport> advance(const std::vector<Passage*>& passages, const std::vector<Leg>& legs,
                                 DeformerCache& cache) {
  std::vector<SolveReport> reports(legs.size());
  std::vector<Way> ways;
  for (std::size_t k = 0; k < legs.size(); ++k) {
    ways.push_back(way_of(*passages[k], legs[k]));
    hold_with(legs[k].active, cache, *passages[k]);
    passages[k]->before = legs[k].now;
  }
  for (int part = 1;; ++part) {
    std::map<const Deformer*, std::vector<std::size_t>> batches;
    for (std::size_t k = 0; k < legs.size(); ++k) {
      if (part <= ways[k].parts) batches[passages[k]->deformer.get()].push_back(k);
    }
    if (batches.empty()) return reports;
    for (const auto& [deformer, members] : batches) {
      std::vector<Frame> frames;
      std::vector<Pose> poses;
      for (const std::size_t k : members) {
        frames.push_back(part_of(ways[k], legs[k], part));
        poses.push_back(std::move(passages[k]->pose));
      }
      const std::vector<SolveReport> solved = deformer->solve(frames, poses);
      for (std::size_t n = 0; n < members.size(); ++n) {
        const int before = reports[members[n]].solves;
        reports[members[n]] = solved[n];
        reports[members[n]].solves += before;
        passages[members[n]]->pose = std::move(poses[n]);
      }
    }
  }
}

}  // namespace flexkey
