#pragma once

#include <optional>
#include <vector>

#include "flexkey/timeline/scope.h"

namespace flexkey {

/// `lambda`: a number, {time: value}, or {keys, ease}. A constant is one key at 0s. Empty if it is wrong.
Track<double> read_lambda(const Node& node, Scope& scope);

/// `sweep`: the values of λ to run, each once. No other key can be swept yet.
std::vector<double> read_sweep(const Node& node, Scope& scope);

}  // namespace flexkey
