#pragma once

#include "flexkey/mesh/error.h"

namespace flexkey {

/// The rest surface, the constraints or a frame's values cannot be solved; the message names what and why.
class DeformError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace flexkey
