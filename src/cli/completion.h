#pragma once

#include <string>
#include <vector>

#include "cli/command_table.h"

namespace flexkey::cli {

/// The scripts with which shells complete a line of flexkey: commands, options, and the files that fit.
std::string bash_completion(const std::vector<Command>& table);
std::string zsh_completion(const std::vector<Command>& table);
std::string fish_completion(const std::vector<Command>& table);

}  // namespace flexkey::cli
