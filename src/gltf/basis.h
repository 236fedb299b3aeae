#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "flexkey/gltf/float_rows.h"
#include "flexkey/gltf/motion.h"

namespace flexkey {

/// A motion as a few morph targets and their weights over time: rest + Σ_t w_t(time) targets_t.
struct Basis {
  std::vector<FloatRows>
      targets;               // #targets of #V x 3, deltas from rest, file units; none where nothing moves
  std::vector<double> keys;  // times at which weights are given, strictly increasing, in frames as
                             // Motion::numbers count them; the first and last are the first and last frame's
  Eigen::MatrixXf weights;   // #keys x #targets, LINEAR between keys
  std::vector<std::string> names;  // #targets, unique
};

/// "f0042": the name of a target of frame 42.
std::string target_name(int frame);

/// One target a frame, of weight 1 at its frame alone: every frame to float rounding.
Basis frame_basis(const Motion& motion);

/// The weights at some times, #times x #targets, as a LINEAR sampler plays them.
Eigen::MatrixXd weights_at(const Basis& basis, std::span<const double> times);

/// The weights at the frames of a motion, #frames x #targets.
Eigen::MatrixXd weights_at_frames(const Basis& basis, std::span<const int> numbers);

/// The farthest that a vertex is played from where it was solved, file units: added up in floats as clients
/// do, at all frames and at the keys between them, where the solved frames are blended linearly. Both are
/// linear in between, so this bounds every time.
double largest_error(const Basis& basis, const Motion& motion);

/// The same motion with all weights in 0..1, for clients that clamp them: w = low + (high − low) u, and
/// Σ low_t targets_t becomes one more target, "mean", of weight 1. Returns it as it is where the weights are
/// in 0..1 already.
Basis with_weights_in_unit_range(const Basis& basis);

}  // namespace flexkey
