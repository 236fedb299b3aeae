#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace flexkey::testing {

struct Outcome {
  int status = -1;
  std::string output;
};

inline Outcome run_shell(const std::string& command) {
  Outcome result;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return result;
  for (int byte = std::fgetc(pipe); byte != EOF; byte = std::fgetc(pipe))
    result.output += static_cast<char>(byte);
  result.status = pclose(pipe);
  return result;
}

/// Whether the Khronos glTF-Validator is there: `npm ci` in VALIDATE_FOLDER installs it.
inline bool has_validator() {
  return run_shell("node --version 2>&1").status == 0 &&
         std::filesystem::exists(std::filesystem::path(VALIDATE_FOLDER) / "node_modules/gltf-validator");
}

/// The validator's lines on these files; its status is 0 where none of them has an error.
inline Outcome validate(const std::vector<std::filesystem::path>& files) {
  std::string command = "node '" VALIDATE_FOLDER "/validate.mjs'";
  for (const std::filesystem::path& file : files) command += " '" + file.string() + "'";
  return run_shell(command + " 2>&1");
}

}  // namespace flexkey::testing
