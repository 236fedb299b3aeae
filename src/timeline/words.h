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
  Value value;
};

/// Reports a word that is none of the known ones: "unknown system 'direkt'; did you mean 'direct'?".
void report_unknown_word(const Node& node, std::string_view what, const std::vector<std::string>& known,
                         Scope& scope);

/// One of a few words. what: "system", for messages.
template <class Value>
std::optional<Value> read_word(const Node& node, std::string_view what,
                               std::initializer_list<Word<Value>> words, Scope& scope) {
  std::vector<std::string> known;
  for (const Word<Value>& word : words) {
    known.emplace_back(word.name);
    if (node.kind == Node::Kind::scalar && node.text == word.name) return word.value;
  }
  report_unknown_word(node, what, known, scope);
  return std::nullopt;
}

}  // namespace flexkey
