#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "flexkey/timeline/diagnostic.h"

namespace flexkey {

/// What findings at a place say besides; empty: nothing.
struct Note {
  Mark where;
  std::string text;
};

/// Collects what is wrong with a timeline, so that one reading reports all of it.
class Findings {
 public:
  void error(Mark where, std::string message);
  void warning(Mark where, std::string message);
  bool has_errors() const { return !errors_.empty(); }
  /// Those of another reading of the same file.
  void take(const Findings& others, const Note& note);

  /// By position, none twice (an alias makes one mistake appear at each of its uses).
  std::vector<Diagnostic> errors() const;
  std::vector<Diagnostic> warnings() const;

  /// "; did you mean 'tip'?", else `otherwise`.
  std::string proposal(std::string_view word, std::span<const std::string> known,
                       std::string otherwise = {}) const;
  /// Whether words are still compared: a file of many errors and many names could make that take minutes.
  bool proposes(std::size_t known_words) const;

 private:
  std::vector<Diagnostic> errors_, warnings_;
};

}  // namespace flexkey
