#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flexkey/timeline/scope.h"

namespace flexkey {

/// One word of a choice, and what it means.
template <class Value>
struct Word {
  std::string_view name;
  std::optional<Value> value;  // nothing: known, not built yet
};

/// Reports a word that is none of the known ones: "unknown system 'direkt'; did you mean 'direct'?".
void report_unknown_word(const Node& node, std::string_view what, const std::vector<std::string>& known,
                         Scope& scope);

/// Warns that a word is not built yet and is ignored.
void report_word_not_built(const Node& node, std::string_view what, Scope& scope);

/// One of a few words. what: "system", for messages.
template <class Value>
std::optional<Value> read_word(const Node& node, std::string_view what,
                               std::initializer_list<Word<Value>> words, Scope& scope) {
  std::vector<std::string> known;
  for (const Word<Value>& word : words) {
    known.emplace_back(word.name);
    if (node.kind != Node::Kind::scalar || node.text != word.name) continue;
    if (!word.value) report_word_not_built(node, what, scope);
    return word.value;
  }
  report_unknown_word(node, what, known, scope);
  return std::nullopt;
}

}  // namespace flexkey
