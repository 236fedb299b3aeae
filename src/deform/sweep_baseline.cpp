#include "flexkey/deform/sweep_kernel.h"

namespace flexkey {

const Sweeps baseline_sweeps = sweeps_of<2>("baseline");

}  // namespace flexkey
