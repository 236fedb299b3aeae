#include "cli/guarded.h"

#include <fmt/format.h>

#include <exception>
#include <new>

#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/options.h"
#include "flexkey/mesh/error.h"
#include "flexkey/timeline/diagnostic.h"

namespace flexkey::cli {

int guarded(const std::function<int()>& command) {
  try {
    return command();
  } catch (const TimelineError& error) {
    for (const Diagnostic& diagnostic : error.diagnostics())
      say(fmt::format("{}\n", format_diagnostic(error.file(), diagnostic)));
    return bad_timeline;
  } catch (const UsageError& error) {
    say(fmt::format("flexkey: error: {}\n", error.what()));
    return bad_timeline;
  } catch (const InputError& error) {
    say(fmt::format("flexkey: error: {}\n", error.what()));
    return bad_input;
  } catch (const OutputError& error) {
    say(fmt::format("flexkey: error: {}\n", error.what()));
    return unwritten;
  } catch (const std::bad_alloc&) {
    say("flexkey: error: out of memory\n");
    return internal_fault;
  } catch (const std::exception& error) {
    say(fmt::format("flexkey: internal fault: {}\n", error.what()));
    return internal_fault;
  }
}

}  // namespace flexkey::cli
