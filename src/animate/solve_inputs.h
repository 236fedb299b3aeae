#pragma once

#include <string>
#include <string_view>

#include "flexkey/animate/hash.h"
#include "flexkey/animate/take.h"

namespace flexkey {

/// What all frames of a take depend on, as the solver gets it: neither on names nor outputs, nor on how the
/// timeline says it.
struct SolveInputs {
  Digest program, surface, handles, solver;
  friend bool operator==(const SolveInputs&, const SolveInputs&) = default;
};

template <MaybeConst<SolveInputs> Self>
auto members_of(Self& inputs) {
  auto& [program, surface, handles, solver] = inputs;
  return std::tie(program, surface, handles, solver);
}

/// program: the build that solves, whose like alone gives the same bytes.
SolveInputs inputs_of(const Take& take, std::string_view program);

/// What a step depends on beyond them: where the handles are and λ, at its own time and, by the digest of
/// the step before it (`{}` before the first), at all times before.
Digest motion_of(const Take& take, int step, const Digest& before);

/// The first thing that differs, as "the mesh has changed"; empty: nothing does.
std::string difference(const SolveInputs& before, const SolveInputs& now);

}  // namespace flexkey
