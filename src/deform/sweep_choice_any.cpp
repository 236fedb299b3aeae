#include "flexkey/deform/sweep.h"

namespace flexkey {

SweepChoice sweeps_for_this_processor() {
  return {1, {&baseline_sweeps}};
}

}  // namespace flexkey
