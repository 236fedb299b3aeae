#include "flexkey/timeline/findings.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "flexkey/mesh/spelling.h"

namespace flexkey {
namespace {

auto order(const Diagnostic& d) {
  return std::tie(d.where.line, d.where.column, d.message);
}

std::vector<Diagnostic> sorted(std::vector<Diagnostic> diagnostics) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.where.line, a.where.column) < std::tie(b.where.line, b.where.column);
  });
  const auto doubles =
      std::unique(diagnostics.begin(), diagnostics.end(),
                  [](const Diagnostic& a, const Diagnostic& b) { return order(a) == order(b); });
  diagnostics.erase(doubles, diagnostics.end());
  return diagnostics;
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
