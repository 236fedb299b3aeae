#pragma once

#include <vector>

#include "flexkey/animate/scene.h"

namespace flexkey::cli {

/// Where the middle of a handle goes over the shot, #times x 3; times: seconds.
Positions path_of(const Scene& scene, int handle, const std::vector<double>& times);

/// How far from rest any of its vertices is asked to go at any of the times, mesh units.
double reach_of(const Scene& scene, int handle, const std::vector<double>& times);

/// Moments of a shot, its frames or evenly fewer where these are many, and both ends.
std::vector<double> moments_to_look_at(const Shot& shot);

/// The times of a handle's keys, increasing; of what it inherits or mirrors none.
std::vector<double> key_times(const Handle& handle);

}  // namespace flexkey::cli
