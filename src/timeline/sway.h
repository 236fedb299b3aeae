#pragma once

#include "flexkey/timeline/motion.h"

namespace flexkey {

/// sin(2π f t + φ), to be multiplied by the amplitude.
double wave_at(const Wave& wave, double time);

/// Gradient noise in −1..1, smooth, 0 at every whole number of 1/f, 0s among them (Perlin, "Improving noise",
/// 2002, in one dimension). The same on every machine.
double noise_at(const Noise& noise, double time);

}  // namespace flexkey
