#pragma once

#include <string>
#include <vector>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/selection.h"

namespace flexkey {

/// One finding about a timeline, at its place. A place on the command line has line 0 and, as column, the
/// number of its `--set` (from 1); `source` then names it.
struct Diagnostic {
  enum class Severity { error, warning };
  Severity severity = Severity::error;
  Mark where;
  std::string message;
  std::string source = {};  // "--set lambda"; empty: the timeline file
};

/// "shot.yaml:13:19: error: unknown key …", one line without the line break. Without a line the place is the
/// file or the diagnostic's source alone; the file "-" reads "<stdin>".
std::string format_diagnostic(const std::string& file, const Diagnostic& diagnostic);

/// A timeline that cannot be run (exit code 2); carries every error found, not only the first.
class TimelineError : public Error {
 public:
  TimelineError(std::string file, std::vector<Diagnostic> diagnostics);
  const std::string& file() const { return file_; }
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::string file_;
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace flexkey
