#include <fmt/format.h>

#include "cli/completion.h"

namespace flexkey::cli {
namespace {

/// Text inside single quotes in which these characters stand for themselves.
std::string escaped(std::string_view text, std::string_view special) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
      continue;
    }
    if (special.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string action_of(const Argument& argument) {
  switch (argument.offer) {
    case Offer::nothing:
      return {};
    case Offer::folder:
      return "_files -/";
    case Offer::file:
      return "_files";
    case Offer::words:
      return fmt::format("({})", fmt::join(argument.words, " "));
    case Offer::timeline:
    case Offer::mesh:
      break;
  }
  return fmt::format("_files -g \"*.({})\"", fmt::join(endings_of(argument.offer), "|"));
}

/// `{-d+,--out-dir=}`: a value may follow at once, or after a space or an equals sign.
std::string names_of(const Argument& argument) {
  std::vector<std::string> names;
  for (const std::string_view name : argument.names)
    names.push_back(fmt::format("{}{}", name, argument.is_flag() ? "" : name[1] == '-' ? "=" : "+"));
  if (names.size() == 1) return names.front();
  return fmt::format("'({})'{{{}}}", fmt::join(argument.names, " "), fmt::join(names, ","));
}

/// An argument as _arguments takes it.
std::string spec_of(const Argument& argument, int place) {
  const std::string value =
      fmt::format(":{}:{}", escaped(argument.value, ":[]"), escaped(action_of(argument), ""));
  if (argument.has_place()) return fmt::format("'{}{}'", place, value);
  const bool is_repeated = std::holds_alternative<std::vector<std::string>*>(argument.target);
  return fmt::format("{}{}'[{}]{}'", is_repeated ? "\\*" : "", names_of(argument),
                     escaped(argument.help, "[]"), argument.is_flag() ? "" : value);
}

std::string case_of(const Command& command) {
  std::string specs;
  int place = 0;
  for (const Argument& argument : command.arguments)
    specs += fmt::format(" \\\n        {}", spec_of(argument, argument.has_place() ? ++place : 0));
  return fmt::format("    {})\n      _arguments{} ;;\n", command.name, specs);
}

}  // namespace

std::string zsh_completion(const std::vector<Command>& table) {
  std::string script =
      "#compdef flexkey\n"
      "# Completion of flexkey in zsh: source <(flexkey completion zsh), or as _flexkey in a folder of "
      "fpath\n"
      "\n"
      "_flexkey() {\n"
      "  local -a commands=(\n";
  for (const Command& command : table)
    script += fmt::format("    '{}:{}'\n", command.name, escaped(command.help, ":"));
  script +=
      "  )\n"
      "  if ((CURRENT == 2)); then\n"
      "    _describe command commands\n"
      "    _arguments";
  for (const Argument& option : program_options()) script += fmt::format(" {}", spec_of(option, 0));
  script +=
      "\n"
      "    return\n"
      "  fi\n"
      "  shift words\n"
      "  ((CURRENT--))\n"
      "  case $words[1] in\n";
  for (const Command& command : table) script += case_of(command);
  return script +
         "  esac\n"
         "}\n"
         "\n"
         "if [[ $funcstack[1] == _flexkey ]]; then _flexkey \"$@\"; else compdef _flexkey flexkey; fi\n";
}

}  // namespace flexkey::cli
