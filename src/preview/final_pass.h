#pragma once

#include "flexkey/preview/picture.h"
#include "flexkey/preview/tracer.h"

namespace flexkey {

/// Everything that a pass over the pixels reads.
struct Studio {
  const View& view;
  const Light& light;
  const DrawnFrame& frame;
};

/// The traced picture. Each pixel depends on the frame alone, not on how the work is shared.
Picture trace_picture(const Studio& studio, const Tracer& tracer, int samples);

/// Where a ray meets the ground, as a distance along it; negative: nowhere, or from below.
float ground_distance(const Light& light, const Ray& ray);

}  // namespace flexkey
