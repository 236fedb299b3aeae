#pragma once

#include <functional>

namespace flexkey::cli {

/// Runs a command and turns what it throws into a message and an exit code: the one place that does.
int guarded(const std::function<int()>& command);

}  // namespace flexkey::cli
