#pragma once

#include <cstdint>

// Also included where code for newer processors is compiled: no inline function may come in by this header,
// or the linker could keep that one's instructions for all.

namespace flexkey {

/// The arrays of a Supernodes.
struct SupernodeView {
  const int* columns;
  const std::int64_t* row_offsets;
  const int* rows;
  const std::int64_t* value_offsets;
  const double* values;
};

/// Substitution with the supernodes from `first` to `end`: L x = b forwards, Lᵀ x = b backwards, in place.
/// x: the right-hand sides side by side, a row of 4, 8 or 16 numbers each, on a boundary of 64 bytes.
using Sweep = void (*)(const SupernodeView& L, int first, int end, double* x);

/// The sweeps for one family of processors, for rows of 4, 8 and 16 numbers.
struct Sweeps {
  const char* name;
  Sweep forward[3];
  Sweep backward[3];
};

extern const Sweeps baseline_sweeps;
extern const Sweeps avx2_sweeps;  // built for x86-64 alone, as the next
extern const Sweeps avx512_sweeps;

/// Those that this processor can run, the fastest first. One of sweep_choice_*.cpp is built.
struct SweepChoice {
  int count;
  const Sweeps* sweeps[3];
};
SweepChoice sweeps_for_this_processor();

}  // namespace flexkey
