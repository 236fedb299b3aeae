#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "flexkey/timeline/keys.h"
#include "flexkey/timeline/node.h"

namespace flexkey {

/// What one mapping of the file says, checked against its table: the keys that have a value.
class Fields {
 public:
  Fields(std::vector<const Entry*> entries, std::vector<std::string> meant)
      : entries_(std::move(entries)), meant_(std::move(meant)) {}

  /// In the file's order.
  const std::vector<const Entry*>& entries() const { return entries_; }
  const Entry* find(std::string_view key) const;
  /// The value of a key, or nothing.
  const Node* value(std::string_view key) const;
  /// Not there, nor present with an error that is reported already (misspelt, without a value).
  bool lacks(std::string_view key) const;

 private:
  std::vector<const Entry*> entries_;
  std::vector<std::string> meant_;  // keys that stand there wrongly
};

/// Checks a mapping against its table: unknown keys are errors. Nothing if the
/// node is no mapping. place: "handle 'tip'" or "'solver'"; empty at the top level.
std::optional<Fields> read_fields(const Node& node, const MappingSpec& spec, std::string_view place,
                                  Findings& findings);

/// The value of a key that must be there; else an error at `where`: "handle 'tip' needs 'select'".
const Node* require(const Fields& fields, std::string_view key, Mark where, std::string_view place,
                    Findings& findings);

/// Checks that a node is a mapping; else an error that shows an example.
bool is_mapping(const Node& node, std::string_view place, std::string_view example, Findings& findings);

/// The names of a table's keys.
std::vector<std::string> known_words(const MappingSpec& spec);

}  // namespace flexkey
