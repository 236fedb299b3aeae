#include "flexkey/deform/sweep_kernel.h"

namespace flexkey {

const Sweeps avx2_sweeps = sweeps_of<4>("avx2");

}  // namespace flexkey
