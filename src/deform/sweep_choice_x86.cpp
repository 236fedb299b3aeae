#include "flexkey/deform/sweep.h"

namespace flexkey {

SweepChoice sweeps_for_this_processor() {
  __builtin_cpu_init();
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl");
  if (avx512) return {3, {&avx512_sweeps, &avx2_sweeps, &baseline_sweeps}};
  if (avx2) return {2, {&avx2_sweeps, &baseline_sweeps}};
  return {1, {&baseline_sweeps}};
}

}  // namespace flexkey
