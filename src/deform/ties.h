#pragma once

#include <vector>

#include "flexkey/deform/rigid.h"
#include "flexkey/deform/soft.h"

namespace flexkey {

/// What ties vertices of F to more than their neighbours, no vertex twice, and the order in which to
/// eliminate them.
struct Ties {
  std::vector<SoftHandle> soft;
  std::vector<RigidRegion> rigid;
  std::vector<int> places = {};  // of each vertex of F in an order with little fill; empty: one is found
};

}  // namespace flexkey
