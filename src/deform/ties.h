#pragma once

#include <vector>

#include "flexkey/deform/rigid.h"
#include "flexkey/deform/soft.h"

namespace flexkey {

/// What ties vertices of F to more than their neighbours. No vertex is tied twice.
struct Ties {
  std::vector<SoftHandle> soft;
  std::vector<RigidRegion> rigid;
};

}  // namespace flexkey
