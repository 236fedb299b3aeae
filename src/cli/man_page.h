#pragma once

#include <string>
#include <vector>

#include "cli/command_table.h"

namespace flexkey::cli {

/// flexkey(1), in the man macros of groff.
std::string man_page(const std::vector<Command>& table);

}  // namespace flexkey::cli
