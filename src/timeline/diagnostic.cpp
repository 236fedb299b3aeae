#include "flexkey/timeline/diagnostic.h"

#include <fmt/format.h>

#include <utility>

namespace flexkey {
namespace {

std::string place_of(const std::string& file, const Diagnostic& diagnostic) {
  if (!diagnostic.source.empty()) return diagnostic.source;
  const std::string name = file == "-" ? "<stdin>" : file;
  if (diagnostic.where.line == 0) return name;
  return fmt::format("{}:{}:{}", name, diagnostic.where.line, diagnostic.where.column);
}

std::string join_lines(const std::string& file, const std::vector<Diagnostic>& diagnostics) {
  std::string lines;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!lines.empty()) lines += '\n';
    lines += format_diagnostic(file, diagnostic);
  }
  return lines;
}

}  // namespace

std::string format_diagnostic(const std::string& file, const Diagnostic& diagnostic) {
  const bool is_error = diagnostic.severity == Diagnostic::Severity::error;
  return fmt::format("{}: {}: {}", place_of(file, diagnostic), is_error ? "error" : "warning",
                     diagnostic.message);
}

TimelineError::TimelineError(std::string file, std::vector<Diagnostic> diagnostics)
    : Error(join_lines(file, diagnostics)), file_(std::move(file)), diagnostics_(std::move(diagnostics)) {}

}  // namespace flexkey
