#pragma once

#include <functional>
#include <span>
#include <vector>

#include "flexkey/animate/clip.h"
#include "flexkey/animate/scene.h"
#include "flexkey/animate/take_state.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// What is known when a frame is solved; good for the length of a call.
struct SolvedStep {
  const FrameReport& report;   // its frame is the number of the step, see timeline/steps.h
  const Positions& positions;  // #V x 3, vertices in the file's order, file units
  const Waypoint& waypoint;    // which the next step starts from
};

/// Whether the frames stay in memory, 24 bytes a vertex each, or only pass by `on_wanted`.
enum class Keep { frames, nothing };

/// What a caller may hear of a running solve.
struct AnimateHooks {
  /// After each step, those that were solved before included; its number is that of its frame, and those of
  /// a cycle's first lap are below 0.
  std::function<void(std::size_t take, const FrameReport&)> on_frame = {};
  std::function<void(std::size_t take, const SolvedFrame&)> on_wanted = {};  // after each of `wanted`
  std::function<void(std::size_t take, const SolvedStep&)> on_solved = {};   // after each step solved now
  std::function<void(std::size_t take, const Waypoint&)> on_end =
      {};                           // of a take that was solved on, stopped or not
  std::function<bool()> stop = {};  // true ends the solve after the current frame
  Keep keep = Keep::frames;         // with `nothing` the clips have reports and no frames
};

/// Solves the shot from frame 0, each frame starting from the one before, and keeps the frames of `wanted`
/// (increasing; all frames where it is empty). The clip ends early where `stop` said so. Frames of
/// Take::before come from there, and the solve goes on behind them to the same bytes. With ping-pong, frames
/// that Take::before has not stay in memory until they have been played backwards.
/// Throws DeformError if the surface cannot be solved.
Clip animate(const Shot& shot, const Mesh& mesh, const Scene& scene, const std::vector<int>& wanted = {},
             const AnimateHooks& hooks = {});

/// Solves shots of one mesh together: they share the factor and pass over it once a step, so that a sweep
/// over λ costs little more than its slowest run. The clips are those of single calls. Throws DeformError
/// also where the takes' constraints differ; the solver's settings are the first take's.
std::vector<Clip> animate(std::span<const Take> takes, const Mesh& mesh, const std::vector<int>& wanted = {},
                          const AnimateHooks& hooks = {});

/// The same for the one-off case: binds the shot and solves all of it.
Clip animate(const Shot& shot, const Mesh& mesh);

/// Where the vertices of Scene::constraints.handles go at a time, #handles x 3.
Positions sample_targets(const Scene& scene, double time);

}  // namespace flexkey
