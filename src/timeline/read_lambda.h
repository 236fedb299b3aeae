#pragma once

#include <vector>

#include "flexkey/timeline/scope.h"
#include "flexkey/timeline/shot.h"

namespace flexkey {

/// λ where a timeline says nothing of it.
inline constexpr double default_lambda = 0.5;

/// What `lambda` says: a track that is empty if it is wrong, where a constant is one key at 0s, and regions
/// with values of their own.
struct Lambda {
  Track<double> keys;
  std::vector<LambdaRegion> regions;
};

/// `lambda`: a number, {time: value}, or {keys, ease, regions}.
Lambda read_lambda(const Node& node, Scope& scope);

}  // namespace flexkey
