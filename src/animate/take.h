#pragma once

#include "flexkey/animate/scene.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

class TakeState;

/// One shot to solve, bound to its mesh.
struct Take {
  const Shot& shot;
  const Scene& scene;
  const TakeState* before = nullptr;  // with what is solved of it already
};

}  // namespace flexkey
