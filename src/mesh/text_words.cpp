#include "flexkey/mesh/text_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/numbers.h"

namespace flexkey {
namespace {

constexpr std::string_view blanks = " \t\r\n";

std::string shown(std::string_view word) {
  return std::string(word.substr(0, 32));
}

}  // namespace

void TextWords::fail(std::string_view message) const {
  throw InputError(fmt::format("{}:{}: {}", name_, line_, message));
}

void TextWords::skip_blanks() {
  while (!left_.empty()) {
    if (comments_ == Comments::hash && left_.front() == '#') {
      left_.remove_prefix(std::min(left_.find('\n'), left_.size()));
    } else if (blanks.find(left_.front()) != std::string_view::npos) {
      if (left_.front() == '\n') ++line_;
      left_.remove_prefix(1);
    } else {
      return;
    }
  }
}

bool TextWords::at_end() {
  skip_blanks();
  return left_.empty();
}

std::string_view TextWords::next(std::string_view what) {
  if (at_end()) fail(fmt::format("the file ends where {} should stand", what));
  const std::string_view ends = comments_ == Comments::hash ? " \t\r\n#" : blanks;
  const std::string_view word = left_.substr(0, left_.find_first_of(ends));
  left_.remove_prefix(word.size());
  return word;
}

double TextWords::coordinate(std::string_view what) {
  const std::string_view word = next(what);
  const auto value = number_of(word);
  if (const std::string_view fault = coordinate_fault(value); !fault.empty())
    fail(fmt::format("{} has the coordinate '{}', {}", what, shown(word), fault));
  return *value;
}

double TextWords::number(std::string_view what) {
  const std::string_view word = next(what);
  const auto value = number_of(word);
  if (!value) fail(fmt::format("'{}' is no number, and {} should stand there", shown(word), what));
  return *value;
}

long long TextWords::whole(std::string_view what, long long low, long long high) {
  const std::string_view word = next(what);
  const auto value = whole_number_of(word);
  if (!value) fail(fmt::format("'{}' is no whole number, and {} should stand there", shown(word), what));
  if (*value < low || *value >= high)
    fail(fmt::format("{} is {}, outside {}..{}", what, *value, low, high - 1));
  return *value;
}

std::string_view TextWords::rest_of_line() {
  std::string_view line = left_.substr(0, left_.find('\n'));
  left_.remove_prefix(line.size());
  if (comments_ == Comments::hash) line = line.substr(0, line.find('#'));
  const std::size_t first = line.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(blanks) - first + 1);
}

}  // namespace flexkey
