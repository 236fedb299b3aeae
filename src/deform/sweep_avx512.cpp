#include "flexkey/deform/sweep_kernel.h"

namespace flexkey {

const Sweeps avx512_sweeps = sweeps_of<8>("avx512");

}  // namespace flexkey
