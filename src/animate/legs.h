#pragma once

#include "flexkey/animate/passage.h"
#include "flexkey/animate/take.h"

namespace flexkey {

/// The way of a take to one of its steps under the handles that hold then; active: active_at or firm_at.
Leg leg_of(const Take& take, const ActiveSet& active, int step);

}  // namespace flexkey
