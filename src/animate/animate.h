#pragma once

#include <functional>
#include <span>
#include <vector>

#include "flexkey/animate/clip.h"
#include "flexkey/animate/scene.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// One shot to solve, bound to its mesh.
struct Take {
  const Shot& shot;
  const Scene& scene;
};

/// Whether the frames stay in memory, 24 bytes a vertex each, or only pass by `on_wanted`.
enum class Keep { frames, nothing };

/// What a caller may hear of a running solve.
struct AnimateHooks {
  std::function<void(std::size_t take, const FrameReport&)> on_frame = {};   // after each solved frame
  std::function<void(std::size_t take, const SolvedFrame&)> on_wanted = {};  // after each of `wanted`
  std::function<bool()> stop = {};  // true ends the solve after the current frame
  Keep keep = Keep::frames;         // with `nothing` the clips have reports and no frames
};

/// Solves the shot from frame 0, each frame starting from the one before, and keeps the frames of `wanted`
/// (increasing; all frames where it is empty). The clip ends early where `stop` said so.
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
