#pragma once

#include <string>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// `active` and `fade` of a handle. place: "handle 'tip'".
void read_activity(const Fields& fields, const std::string& place, Scope& scope, Handle& handle);

}  // namespace flexkey
