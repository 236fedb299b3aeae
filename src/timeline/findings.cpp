#include "flexkey/timeline/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "flexkey/mesh/spelling.h"

namespace flexkey {
namespace {

std::vector<Diagnostic> sorted(std::vector<Diagnostic> diagnostics) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.where.line, a.where.column) < std::tie(b.where.line, b.where.column);
  });
  std::set<std::tuple<int, int, std::string_view>> said;
  std::vector<Diagnostic> once;
  for (const Diagnostic& diagnostic : diagnostics) {
    const auto& [line, column] = diagnostic.where;
    if (said.emplace(line, column, diagnostic.message).second) once.push_back(diagnostic);
  }
  return once;
}

/// A message that stays one short line, whatever text of the file it quotes.
std::string one_line(std::string message) {
  constexpr std::size_t longest = 600;
  if (message.size() > longest) {
    std::size_t end = longest;
    while ((static_cast<unsigned char>(message[end]) & 0xC0) == 0x80) --end;  // not within a character
    message.resize(end);
    message += "…";
  }
  std::replace_if(
      message.begin(), message.end(), [](char c) { return (c >= 0 && c < ' ') || c == 0x7F; }, ' ');
  return message;
}

}  // namespace

void Findings::error(Mark where, std::string message) {
  errors_.push_back({Diagnostic::Severity::error, where, one_line(std::move(message))});
}

void Findings::warning(Mark where, std::string message) {
  warnings_.push_back({Diagnostic::Severity::warning, where, one_line(std::move(message))});
}

std::vector<Diagnostic> Findings::errors() const {
  return sorted(errors_);
}
std::vector<Diagnostic> Findings::warnings() const {
  return sorted(warnings_);
}

void Findings::take(const Findings& others, const Note& note) {
  const auto noted = [&](Diagnostic diagnostic) {
    const auto& [line, column] = diagnostic.where;
    if (!note.text.empty() && line == note.where.line && column == note.where.column)
      diagnostic.message += fmt::format(" ({})", note.text);
    return diagnostic;
  };
  for (const Diagnostic& error : others.errors_) errors_.push_back(noted(error));
  for (const Diagnostic& warning : others.warnings_) warnings_.push_back(noted(warning));
}

bool Findings::proposes(std::size_t known_words) const {
  constexpr std::size_t most_errors = 50, most_words = 1000;
  return errors_.size() < most_errors && known_words <= most_words;
}

std::string Findings::proposal(std::string_view word, std::span<const std::string> known,
                               std::string otherwise) const {
  if (!proposes(known.size())) return otherwise;
  std::string tail = did_you_mean(word, known);
  return tail.empty() ? otherwise : tail;
}

}  // namespace flexkey
