#include "flexkey/timeline/words.h"

#include <fmt/format.h>

namespace flexkey {

void report_unknown_word(const Node& node, std::string_view what, const std::vector<std::string>& known,
                         Scope& scope) {
  const std::string list = fmt::format("{}", fmt::join(known, ", "));
  if (node.kind != Node::Kind::scalar) {
    scope.findings.error(node.where, fmt::format("{} is one of {}, not {}", what, list, describe(node)));
    return;
  }
  scope.findings.error(node.where,
                       fmt::format("unknown {} '{}'{}", what, node.text,
                                   scope.findings.proposal(node.text, known, "; known are " + list)));
}

}  // namespace flexkey
