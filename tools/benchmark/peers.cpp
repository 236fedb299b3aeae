#include "peers.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <limits>
#include <utility>

#include "child.h"
#include "clock.h"
#include "motion.h"
#include "side.h"

namespace flexkey::bench {
namespace {

constexpr int iterations_a_frame = 5;

using MakeSide = std::function<Side(Motion& motion)>;  // may take the motion's mesh

/// Plain iteration, as many as asked for and not one less.
DeformOptions plain_options(int iterations) {
  return {.system = System::direct,
          .iterations = iterations,
          .tolerance = std::numeric_limits<double>::min(),
          .predict = false,
          .accelerate = false};
}

MakeSide flexkey(const DeformOptions& options, double lambda) {
  return [=](Motion& motion) {
    return flexkey_side(std::move(motion.mesh), motion.constraints, options, lambda);
  };
}

MakeSide plain(int iterations) {
  return flexkey(plain_options(iterations), 1);
}

MakeSide standard() {
  return flexkey({.system = System::direct}, 0.8);
}

MakeSide cgal(int iterations) {
  return [=](Motion& motion) {
    const Mesh mesh = std::move(motion.mesh);
    return cgal_side(mesh, motion.constraints, iterations);
  };
}

/// Seconds of one iteration: of enough frames to trust, from the first on.
template <class Clock>
double iteration_seconds(const Side& side, const Motion& motion, const Clock& clock) {
  constexpr std::size_t least_frames = 3;
  constexpr double enough = 0.3;  // seconds
  double seconds = 0;
  int iterations = 0;
  for (std::size_t frame = 0; frame < motion.frames.size(); ++frame) {
    if (frame >= least_frames && seconds > enough) break;
    seconds += seconds_of(clock, [&] { iterations += side.solve(motion.frames[frame]).solves; });
  }
  return seconds / iterations;
}

/// Work in a process of its own, on so many threads.
Measured in_child_on(int threads, const std::function<std::vector<double>()>& work) {
  return in_child([&] {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    return work();
  });
}

StepCost step_cost(int blob, const MakeSide& make) {
  const Measured measured = in_child_on(1, [&]() -> std::vector<double> {
    Motion motion = blob_motion(blob);
    const Side side = make(motion);
    const double set_up = seconds_of(cpu_seconds, side.set_up);
    return {set_up, iteration_seconds(side, motion, cpu_seconds)};
  });
  return {measured.values[0], measured.values[1], measured.peak_bytes};
}

struct Clip {
  ClipCost cost;
  std::vector<double> answer;  // coordinates of some vertices in the last frame
};

/// A thousand numbers of the last frame, spread over the surface.
std::vector<double> sample(const Positions& positions) {
  const Eigen::Index stride = std::max<Eigen::Index>(1, positions.size() / 1000);
  std::vector<double> values;
  for (Eigen::Index k = 0; k < positions.size(); k += stride) values.push_back(positions.data()[k]);
  return values;
}

Clip clip_cost(int blob, const MakeSide& make) {
  const Measured measured = in_child_on(1, [&] {
    Motion motion = blob_motion(blob);
    const Side side = make(motion);
    side.set_up();
    double solves = 0, converged = 0;
    const double seconds = seconds_of(cpu_seconds, [&] {
      for (const Targets& targets : motion.frames) {
        const SolveReport report = side.solve(targets);
        solves += report.solves;
        converged += report.converged ? 1 : 0;
      }
    });
    const double frames = static_cast<double>(motion.frames.size());
    std::vector<double> values = sample(side.positions());
    values.insert(values.begin(), {seconds, solves / frames, converged / frames});
    return values;
  });
  const auto& values = measured.values;
  return {{values[0], values[1], values[2]}, {values.begin() + 3, values.end()}};
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

/// Vertices and diagonal of the blob, made where they leave no pages behind.
std::pair<int, double> extent_of(int blob) {
  const Measured measured = in_child([&]() -> std::vector<double> {
    const Mesh mesh = blob_motion(blob).mesh;
    return {static_cast<double>(mesh.vertex_count()), bounds_of(mesh.positions).diagonal()};
  });
  return {static_cast<int>(measured.values[0]), measured.values[1]};
}

}  // namespace

PeerResult compare_with_peer(const Size& size) {
  PeerResult result{.size = size};
  const auto [vertices, diagonal] = extent_of(size.blob);
  result.vertices = vertices;
  // The two take turns, so that a change in the machine's speed meets both.
  for (int k = 0; k < size.step_repetitions; ++k) {
    result.cgal.push_back(step_cost(size.blob, cgal(iterations_a_frame)));
    result.plain.push_back(step_cost(size.blob, plain(iterations_a_frame)));
    result.standard.push_back(step_cost(size.blob, standard()));
  }
  for (int k = 0; k < size.clip_repetitions; ++k) {
    const Clip theirs = clip_cost(size.blob, cgal(2)), ours = clip_cost(size.blob, plain(2));
    result.cgal_2.push_back(theirs.cost);
    result.plain_2.push_back(ours.cost);
    result.difference = largest_difference(theirs.answer, ours.answer) / diagonal;
    result.cgal_5.push_back(clip_cost(size.blob, cgal(iterations_a_frame)).cost);
    result.converged.push_back(clip_cost(size.blob, standard()).cost);
  }
  return result;
}

double iteration_on_threads(int blob, int threads) {
  const Measured measured = in_child_on(threads, [&]() -> std::vector<double> {
    Motion motion = blob_motion(blob);
    const Side side = plain(iterations_a_frame)(motion);
    side.set_up();
    return {iteration_seconds(side, motion, wall_seconds)};
  });
  return measured.values[0];
}

}  // namespace flexkey::bench
