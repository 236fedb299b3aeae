#pragma once

#include <optional>
#include <span>

#include "flexkey/animate/archive.h"
#include "flexkey/animate/passage.h"

namespace flexkey {

/// All that a take's next frame starts from.
struct Waypoint {
  int next = 0;                           // the number of that frame
  Passage passage;                        // at the frame before
  std::optional<Passage> without_fading;  // see advance_without_fading, while handles fade
};

/// At rest before the first frame.
Waypoint first_waypoint(const Scene& scene, DeformerCache& cache);

/// Saves all of it but the deformers.
void save(const Waypoint& waypoint, Saving& saving);

/// A waypoint of this scene that was saved. Throws ArchiveError for bytes that are none.
Waypoint load_waypoint(std::span<const std::byte> bytes, const Scene& scene, DeformerCache& cache);

}  // namespace flexkey
