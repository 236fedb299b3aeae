#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace flexkey::test {

struct ProgramResult {
  int exit_code = -1;  // 128 + n where signal n ended it
  std::string output;  // stdout
  std::string errors;  // stderr
};

struct Surroundings {
  std::string input;     // of standard input
  std::string wrapper;   // a command that runs the program, such as `timeout -s INT 1`
  std::string redirect;  // such as `2>/dev/full`
};

/// Runs build/flexkey in `folder` with these arguments.
ProgramResult run_program(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                          const Surroundings& surroundings = {});

}  // namespace flexkey::test
