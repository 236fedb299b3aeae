#include "cli/value_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "flexkey/timeline/number.h"

namespace flexkey::cli {
namespace {

/// Reads forms from the front of a text.
class FormReader {
 public:
  explicit FormReader(std::string_view text) : rest_(text) {}

  bool take(std::string_view word) {
    skip_spaces();
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }

  std::vector<ValueForm> alternatives() {
    std::vector<ValueForm> forms{form()};
    while (take("|")) forms.push_back(form());
    return forms;
  }

  void require_end() {
    skip_spaces();
    if (!rest_.empty()) fail();
  }

 private:
  void skip_spaces() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }
  [[noreturn]] void fail() const {
    throw std::invalid_argument(fmt::format("no form of values at '{}'", rest_));
  }
  void require(std::string_view word) {
    if (!take(word)) fail();
  }

  /// Up to one of these characters, which stays.
  std::string until(std::string_view ends) {
    const std::size_t end = std::min(rest_.find_first_of(ends), rest_.size());
    const std::string text(trimmed(rest_.substr(0, end)));
    rest_.remove_prefix(end);
    if (text.empty()) fail();
    return text;
  }

  ValueForm form() {
    skip_spaces();
    if (take("'")) {
      ValueForm word{until("'"), {}, {}, {}};
      word.name = fmt::format("'{}'", word.name);
      require("'");
      return word;
    }
    if (take("{track of")) {
      ValueForm track{"{track}", {}, {}, alternatives()};
      require("}");
      return track;
    }
    if (take("{")) {
      ValueForm mapping{fmt::format("{{{}}}", until("}")), {}, {}, {}};
      require("}");
      return mapping;
    }
    ValueForm plain{until(" |([)}"), {}, {}, {}};
    if (plain.name == "number" || plain.name == "whole") {
      read_range(plain);
    } else if (take("(")) {
      plain.of = alternatives();
      require(")");
    }
    return plain;
  }

  void read_range(ValueForm& form) {
    const bool with_least = rest_.starts_with('[');
    if (!with_least && !rest_.starts_with('(')) return;
    rest_.remove_prefix(1);
    form.least = RangeEnd{number(","), with_least};
    require(",");
    if (take(")") || take("]")) return;
    form.most = RangeEnd{number(")]"), true};
    form.most->is_inside = rest_.starts_with(']');
    rest_.remove_prefix(std::min<std::size_t>(1, rest_.size()));
  }

  double number(std::string_view ends) {
    const std::optional<double> value = parse_number(until(ends));
    if (!value) fail();
    return *value;
  }

  std::string_view rest_;
};

}  // namespace

KeyForm parse_key_form(std::string_view text) {
  FormReader reader(text);
  KeyForm key;
  key.is_required = reader.take("required ");
  key.forms = reader.alternatives();
  reader.require_end();
  return key;
}

}  // namespace flexkey::cli
