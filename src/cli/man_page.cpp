#include "cli/man_page.h"

#include <fmt/format.h>

namespace flexkey::cli {
namespace {

/// Text that roff prints as it is, also to be copied: no hyphen for a minus, no curly quotes.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '\\':
        result += "\\e";
        break;
      case '-':
        result += "\\-";
        break;
      case '\'':
        result += "\\(aq";
        break;
      case '`':
        result += "\\(ga";
        break;
      case '^':
        result += "\\(ha";
        break;
      case '~':
        result += "\\(ti";
        break;
      case '"':
        result += "\\(dq";
        break;
      default:
        result += c;
    }
  }
  return result.starts_with('.') ? fmt::format("\\&{}", result) : result;
}

std::string bold(std::string_view text) {
  return fmt::format("\\fB{}\\fR", escaped(text));
}

std::string italic(std::string_view text) {
  return fmt::format("\\fI{}\\fR", escaped(text));
}

std::string entry(const Argument& argument) {
  std::vector<std::string> names;
  for (const std::string_view name : argument.names) names.push_back(bold(name));
  std::string head = argument.has_place() ? italic(argument.value)
                     : argument.is_flag()
                         ? fmt::format("{}", fmt::join(names, ", "))
                         : fmt::format("{} {}", fmt::join(names, ", "), italic(argument.value));
  return fmt::format(".TP\n{}\n{}.\n", head, escaped(argument.help));
}

std::string section(const Command& command) {
  std::string places, entries;
  for (const Argument& argument : command.arguments) {
    if (argument.has_place())
      places += argument.is_required ? fmt::format(" {}", italic(argument.value))
                                     : fmt::format(" [{}]", italic(argument.value));
    entries += entry(argument);
  }
  return fmt::format(
      ".SS flexkey {}\n"
      "{}{} [options]\n"
      ".PP\n"
      "{}.\n"
      "{}"
      ".PP\n"
      "Example:\n"
      ".PP\n"
      ".EX\n"
      "{}\n"
      ".EE\n",
      escaped(command.name), bold(fmt::format("flexkey {}", command.name)), places, escaped(command.help),
      entries, escaped(command.example));
}

constexpr const char* head = R"(.SH NAME
flexkey \- animate a mesh without a rig, by a text timeline
.SH SYNOPSIS
.B flexkey
.I COMMAND
[options]
.SH DESCRIPTION
)";

constexpr const char* about = R"(
A timeline is a YAML file that says where parts of a mesh go over time,
and how rigid or smooth the surface is at each key.
.B flexkey init
writes a first one for a mesh.
)";

constexpr const char* tail = R"(.SH ENVIRONMENT
.TP
.B SLURM_CPUS_PER_TASK
How many threads to use where
.B \-\-threads
does not say.
.SH FILES
.TP
.I DIR\fB/.flexkey/\fPSHOT\fB/
The solved frames of a shot, in the folder that its outputs go to.
A stopped command goes on from them; they may be deleted at any time.
)";

}  // namespace

std::string man_page(const std::vector<Command>& table) {
  std::string page = fmt::format(".TH FLEXKEY 1 \"\" \"flexkey {}\" \"User Commands\"\n{}{}{}.SH OPTIONS\n",
                                 FLEXKEY_VERSION, head, escaped(program_summary), about);
  for (const Argument& option : program_options()) page += entry(option);
  page += ".SH COMMANDS\n";
  for (const Command& command : table) page += section(command);
  page += ".SH EXIT STATUS\n";
  for (const ExitCodeText& row : exit_code_texts())
    page += fmt::format(".TP\n{}\n{}.\n", bold(row.code), escaped(row.meaning));
  return page + tail;
}

}  // namespace flexkey::cli
