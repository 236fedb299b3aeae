#pragma once

#include <filesystem>
#include <vector>

#include "motion.h"

namespace flexkey::bench {

/// How a frame begins and goes on: from rest, from the frame before, that with Anderson acceleration, and
/// that with the predicted rotations as well (the default).
enum class Start { cold, warm, accelerated, predicted };

/// One way to solve: a line of the tables.
struct Setting {
  System system = System::least_squares;
  LocalScale local_scale = LocalScale::uniform;
  double lambda = 0;
};

/// λ in {0, 0.2, 0.5, 0.8} in both systems with the local scales `uniform` and `axis`, and λ = 1, where r has
/// no S_i.
std::vector<Setting> all_settings();

/// The frames of a motion, or of several.
struct Tally {
  int frames = 0;
  int solves = 0;     // a frame that the cap stopped counts the cap
  int converged = 0;  // frames reported converged
  double solves_a_frame() const { return static_cast<double>(solves) / frames; }
  double converged_share() const { return static_cast<double>(converged) / frames; }
  Tally& operator+=(const Tally& other);
};

/// Global solves until the solver's own stop at 0.1 % of the diagonal. The cap is the default one for
/// `predicted`, and 200 for the others.
Tally count_solves(const Motion& motion, const Setting& setting, Start start);

/// The whole of a timeline's shot as it is, by its own λ and settings; frames that only repeat the one before
/// do not count.
Tally count_shot(const std::filesystem::path& timeline);

/// How far frames that were reported converged are from where their own iteration leads.
struct Honesty {
  int claimed = 0;  // frames reported converged
  int checked = 0;  // of those, carried on to 1e-9 of the diagonal, or as far as that goes
  int unsettled =
      0;  // of those checked, still not at 1e-9 after many more solves; their distance is a lower bound
  int beyond = 0;    // of those checked, farther away than twice the tolerance
  double worst = 0;  // the largest distance, a share of the diagonal
  Honesty& operator+=(const Honesty& other);
};

/// Of at most a dozen frames of the motion, evenly spread, with the default start. They are carried on with
/// Anderson acceleration: plain iteration goes to the same points, but for thousands of solves.
Honesty check_honesty(const Motion& motion, const Setting& setting);

}  // namespace flexkey::bench
