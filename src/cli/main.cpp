#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "cli/command_table.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/guarded.h"
#include "cli/interrupt.h"
#include "cli/previews.h"
#include "flexkey/deform/cholesky.h"
#include "flexkey/mesh/spelling.h"

namespace {

using namespace flexkey;
using namespace flexkey::cli;

CLI::Option* add_option(CLI::App& command, const Argument& argument) {
  const std::string names = fmt::format("{}", fmt::join(argument.names, ","));
  const std::string help(argument.help);
  const auto add = [&](auto* target) -> CLI::Option* {
    using Value = std::remove_pointer_t<decltype(target)>;
    if constexpr (std::is_same_v<Value, bool>) {
      return target ? command.add_flag(names, *target, help) : command.set_help_flag(names, help);
    } else {
      CLI::Option* option = command.add_option(names, *target, help);
      if constexpr (std::is_same_v<Value, int>) option->check(CLI::Range(1, 1024));
      if constexpr (std::is_same_v<Value, std::vector<std::string>>)
        option->expected(1)->take_all()->trigger_on_parse(false);
      return option;
    }
  };
  return std::visit(add, argument.target);
}

void add_command(CLI::App& app, const Command& command) {
  CLI::App* added = app.add_subcommand(std::string(command.name), std::string(command.help));
  for (const Argument& argument : command.arguments) {
    CLI::Option* option = add_option(*added, argument);
    if (!argument.is_flag()) option->type_name(std::string(argument.value));
    if (argument.is_required) option->required();
    if (argument.offer == Offer::words)
      option->check(CLI::IsMember(std::vector<std::string>(argument.words.begin(), argument.words.end())));
  }
  added->footer(fmt::format("Example:\n  {}\n", command.example));
}

std::string exit_codes() {
  std::string text = "Exit codes:\n";
  for (const ExitCodeText& row : exit_code_texts()) text += fmt::format("  {:9}{}\n", row.code, row.meaning);
  return text;
}

/// What is wrong with the command's name, or nothing; flags and no name at all are left to CLI11.
std::string unknown_command(int argc, char** argv, const std::vector<Command>& table) {
  if (argc < 2 || argv[1][0] == '-') return {};
  const std::string name = argv[1];
  std::vector<std::string> names;
  for (const Command& command : table) names.emplace_back(command.name);
  if (std::find(names.begin(), names.end(), name) != names.end()) return {};
  return fmt::format("unknown command '{}'{}", name, did_you_mean(name, names));
}

/// With what this build can and cannot do.
std::string version() {
  return fmt::format("flexkey {}\nfactors with {}; {}", FLEXKEY_VERSION, factoring_library(),
                     draws_previews() ? "draws previews" : "built without previews");
}

}  // namespace

int main(int argc, char** argv) {
  Request request;
  const std::vector<Command> table = command_table(request);
  CLI::App app(std::string(program_summary), "flexkey");
  app.set_version_flag("--version", version());
  app.require_subcommand(1);
  app.footer(exit_codes());
  for (const Command& command : table) add_command(app, command);

  report_failed_writes();
  if (const std::string unknown = unknown_command(argc, argv, table); !unknown.empty()) {
    say(fmt::format("flexkey: error: {}\n", unknown));
    return bad_timeline;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (app.exit(error) != 0) return bad_timeline;
    return std::cout.flush() ? done : unwritten;
  }
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(thread_count(request.shot.threads)));
  const std::string chosen = app.get_subcommands().front()->get_name();
  const auto command =
      std::find_if(table.begin(), table.end(), [&](const Command& c) { return c.name == chosen; });
  return guarded(command->run);
}
