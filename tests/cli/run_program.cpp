#include "cli/run_program.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>

#include "flexkey/mesh/read_file.h"

namespace flexkey::test {
namespace {

std::string quoted(const std::string& word) {
  std::string result;
  for (const char c : word) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      result += c;
    }
  }
  return fmt::format("'{}'", result);
}

}  // namespace

ProgramResult run_program(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                          const Surroundings& surroundings) {
  const std::filesystem::path captured = folder / ".captured";
  std::filesystem::create_directories(captured);
  std::ofstream(captured / "in") << surroundings.input;
  std::string words;
  for (const std::string& argument : arguments) words += fmt::format(" {}", quoted(argument));
  const std::string command =
      fmt::format("cd {} && {} {}{} <.captured/in >.captured/out 2>.captured/err {}", quoted(folder.string()),
                  surroundings.wrapper, quoted(FLEXKEY_PROGRAM), words, surroundings.redirect);
  const int status = std::system(command.c_str());
  ProgramResult result;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.output = read_file(captured / "out");
  result.errors = read_file(captured / "err");
  std::filesystem::remove_all(captured);
  return result;
}

}  // namespace flexkey::test
