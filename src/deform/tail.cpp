#include "flexkey/deform/tail.h"

#include <algorithm>
#include <limits>

namespace flexkey {

double GeometricTail::after(double step) {
  const double unknown = std::numeric_limits<double>::infinity();
  const double ratio = step_ > 0 ? step / step_ : 0;
  const double contraction = std::max(ratio, ratio_);  // of two, as one may be small by chance
  step_ = step;
  ratio_ = ratio;
  ++steps_;
  if (step == 0) return 0;
  return steps_ < 3 || contraction >= 1 ? unknown : step * contraction / (1 - contraction);
}

}  // namespace flexkey
