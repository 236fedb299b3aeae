#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace flexkey::cli {

/// One end of a range of numbers.
struct RangeEnd {
  double value = 0;
  bool is_inside = true;
};

/// A form of values, as KeySpec::form writes it.
struct ValueForm {
  std::string name;  // "number", "list", "{solver}", "{track}", or with quotes a word
  std::optional<RangeEnd> least, most;
  std::vector<ValueForm> of;  // the forms of what it holds, each of them allowed
};

/// What may stand behind a key.
struct KeyForm {
  bool is_required = false;
  std::vector<ValueForm> forms;
};

/// Throws std::invalid_argument for a text that is none.
KeyForm parse_key_form(std::string_view text);

}  // namespace flexkey::cli
