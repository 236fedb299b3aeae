#include <fmt/format.h>

#include "cli/completion.h"

namespace flexkey::cli {
namespace {

constexpr const char* helpers = R"(# Completion of flexkey in bash: source <(flexkey completion bash)

# Folders, and the files of these patterns.
_flexkey_files() {
  local pattern
  mapfile -t COMPREPLY < <(compgen -d -- "$cur"; for pattern; do compgen -f -X "!$pattern" -- "$cur"; done)
  compopt -o filenames 2>/dev/null
}

_flexkey_words() {
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$cur")
}

_flexkey() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]}
  # To bash --option=value is three words.
  [[ $cur == = ]] && cur=
  [[ $prev == = ]] && prev=${COMP_WORDS[COMP_CWORD - 2]}
  COMPREPLY=()
)";

/// The call that offers an argument's values.
std::string offer_of(const Argument& argument) {
  std::string call;
  switch (argument.offer) {
    case Offer::nothing:
      return ":";
    case Offer::folder:
      return "_flexkey_files";
    case Offer::file:
      return "_flexkey_files '*'";
    case Offer::words:
      return fmt::format("_flexkey_words '{}'", fmt::join(argument.words, " "));
    case Offer::timeline:
    case Offer::mesh:
      break;
  }
  call = "_flexkey_files";
  for (const std::string_view ending : endings_of(argument.offer)) call += fmt::format(" '*.{}'", ending);
  return call;
}

std::string names_of(const std::vector<Argument>& arguments) {
  std::vector<std::string_view> names;
  for (const Argument& argument : arguments)
    if (!argument.has_place()) names.insert(names.end(), argument.names.begin(), argument.names.end());
  return fmt::format("{}", fmt::join(names, " "));
}

/// The cases of a command: a value where its option stands before it, else options or the first argument.
std::string cases_of(const Command& command) {
  std::string cases, place = ":";
  for (const Argument& argument : command.arguments) {
    if (argument.has_place()) {
      if (place == ":") place = offer_of(argument);
    } else if (!argument.is_flag()) {
      const std::string separator = fmt::format(" | {}:", command.name);
      cases += fmt::format("    {}:{}) {} ;;\n", command.name, fmt::join(argument.names, separator),
                           offer_of(argument));
    }
  }
  return fmt::format("{}    {}:*) if [[ $cur == -* ]]; then _flexkey_words '{}'; else {}; fi ;;\n", cases,
                     command.name, names_of(command.arguments), place);
}

}  // namespace

std::string bash_completion(const std::vector<Command>& table) {
  std::vector<std::string_view> commands;
  for (const Command& command : table) commands.push_back(command.name);
  std::string script = fmt::format(
      "{}"
      "  if ((COMP_CWORD == 1)); then\n"
      "    _flexkey_words '{} {}'\n"
      "    return\n"
      "  fi\n"
      "  case ${{COMP_WORDS[1]}}:$prev in\n",
      helpers, fmt::join(commands, " "), names_of(program_options()));
  for (const Command& command : table) script += cases_of(command);
  return script + "  esac\n}\n\ncomplete -F _flexkey flexkey\n";
}

}  // namespace flexkey::cli
