#include "cli/command_table.h"
#include "cli/completion.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/man_page.h"

namespace flexkey::cli {

int run_completion(const CompletionOptions& options) {
  Request request;
  const std::vector<Command> table = command_table(request);
  if (options.shell == "zsh") {
    print_result(zsh_completion(table));
  } else if (options.shell == "fish") {
    print_result(fish_completion(table));
  } else {
    print_result(bash_completion(table));
  }
  return done;
}

int run_man() {
  Request request;
  print_result(man_page(command_table(request)));
  return done;
}

}  // namespace flexkey::cli
