#include <fmt/format.h>

#include "cli/completion.h"

namespace flexkey::cli {
namespace {

std::string quoted(std::string_view text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return result + "'";
}

std::string offer_of(const Argument& argument) {
  switch (argument.offer) {
    case Offer::nothing:
      return {};
    case Offer::folder:
      return " -a '(__fish_complete_directories)'";
    case Offer::file:
      return " -F";
    case Offer::words:
      return fmt::format(" -a '{}'", fmt::join(argument.words, " "));
    case Offer::timeline:
    case Offer::mesh:
      break;
  }
  return fmt::format(" -k -a '(__fish_complete_suffix .{})'", fmt::join(endings_of(argument.offer), " ."));
}

std::string names_of(const Argument& argument) {
  std::string names;
  for (const std::string_view name : argument.names)
    names += name[1] == '-' ? fmt::format(" -l {}", name.substr(2)) : fmt::format(" -s {}", name.substr(1));
  return names;
}

/// One line, which holds under this condition.
std::string line_of(const Argument& argument, const std::string& condition) {
  std::string line = fmt::format("complete -c flexkey -n '{}'", condition);
  if (!argument.has_place()) line += names_of(argument);
  if (!argument.is_flag() && !argument.has_place()) line += " -r";
  line += argument.is_flag() ? std::string() : offer_of(argument);
  if (!argument.has_place()) line += fmt::format(" -d {}", quoted(argument.help));
  return line + "\n";
}

}  // namespace

std::string fish_completion(const std::vector<Command>& table) {
  constexpr const char* no_command = "__fish_use_subcommand";
  std::string script =
      "# Completion of flexkey in fish: flexkey completion fish | source\n"
      "complete -c flexkey -f\n";
  for (const Argument& option : program_options()) script += line_of(option, no_command);
  for (const Command& command : table) {
    script += fmt::format("\ncomplete -c flexkey -n {} -a {} -d {}\n", no_command, command.name,
                          quoted(command.help));
    const std::string condition = fmt::format("__fish_seen_subcommand_from {}", command.name);
    for (const Argument& argument : command.arguments)
      if (!argument.has_place() || argument.offer != Offer::nothing) script += line_of(argument, condition);
  }
  return script;
}

}  // namespace flexkey::cli
