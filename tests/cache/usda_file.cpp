#include "cache/usda_file.h"

#include <cctype>
#include <stdexcept>
#include <string_view>

namespace flexkey::test {
namespace {

using nlohmann::json;

class UsdaReader {
 public:
  explicit UsdaReader(std::string_view text) : left_(text) {}

  UsdaFile file() {
    expect("#usda 1.0");
    UsdaFile file;
    if (next_is('(')) file.metadata = metadata();
    while (!at_end()) file.prims.push_back(prim());
    return file;
  }

 private:
  [[noreturn]] void fail(std::string_view wanted) const {
    throw std::runtime_error("wanted " + std::string(wanted) + " at '" + std::string(left_.substr(0, 40)) +
                             "'");
  }

  void skip_space() {
    while (!left_.empty() && std::isspace(static_cast<unsigned char>(left_.front()))) left_.remove_prefix(1);
  }
  bool at_end() {
    skip_space();
    return left_.empty();
  }
  bool next_is(char c) {
    skip_space();
    return left_.starts_with(c);
  }
  bool take(char c) {
    if (!next_is(c)) return false;
    left_.remove_prefix(1);
    return true;
  }
  void expect(std::string_view word) {
    skip_space();
    if (!left_.starts_with(word)) fail(word);
    left_.remove_prefix(word.size());
  }

  /// Letters, digits and the given signs.
  std::string word(std::string_view signs) {
    skip_space();
    std::size_t length = 0;
    while (length < left_.size() && (std::isalnum(static_cast<unsigned char>(left_[length])) ||
                                     signs.find(left_[length]) != std::string_view::npos))
      ++length;
    if (length == 0) fail("a word");
    const std::string found(left_.substr(0, length));
    left_.remove_prefix(length);
    return found;
  }

  std::string quoted() {
    expect("\"");
    const std::size_t end = left_.find_first_of("\"\n");
    if (end == std::string_view::npos || left_[end] == '\n') fail("a closing quote");
    const std::string text(left_.substr(0, end));
    left_.remove_prefix(end + 1);
    return text;
  }

  json number() {
    const std::string text = word("+-.");
    std::size_t used = 0;
    const double value = std::stod(text, &used);
    if (used != text.size()) fail("a number");
    return value;
  }

  json sequence(char open, char close) {
    json items = json::array();
    if (!take(open)) fail("a list");
    while (!take(close)) {
      items.push_back(value());
      if (!take(',') && !next_is(close)) fail("a comma");
    }
    return items;
  }

  json samples() {
    json by_time = json::object();
    double last = -1;
    expect("{");
    while (!take('}')) {
      const std::string time = word("-.");
      if (std::stod(time) <= last) fail("times that increase");
      last = std::stod(time);
      expect(":");
      by_time[time] = value();
      if (!take(',') && !next_is('}')) fail("a comma");
    }
    return by_time;
  }

  json value() {
    if (next_is('[')) return sequence('[', ']');
    if (next_is('(')) return sequence('(', ')');
    if (next_is('"')) return quoted();
    return number();
  }

  json metadata() {
    json entries = json::object();
    expect("(");
    while (!take(')')) {
      const std::string key = word("_:");
      expect("=");
      entries[key] = value();
    }
    return entries;
  }

  void attribute(UsdaPrim& prim, const std::string& first_word) {
    UsdaAttribute attribute{first_word, {}, {}};
    if (first_word == "uniform") attribute.type += " " + word("[]");
    const std::string name = word("_:.");
    expect("=");
    const bool is_sampled = name.ends_with(".timeSamples");
    attribute.value = is_sampled ? samples() : value();
    if (next_is('(')) attribute.metadata = metadata();
    if (!prim.attributes.emplace(name, attribute).second) fail("an attribute only once");
  }

  UsdaPrim prim() {
    expect("def");
    return prim_after_def();
  }

  UsdaPrim prim_after_def() {
    UsdaPrim prim;
    prim.type = word("");
    prim.name = quoted();
    expect("{");
    while (!take('}')) {
      const std::string first = word("[]");
      if (first == "def") {
        prim.children.push_back(prim_after_def());
      } else {
        attribute(prim, first);
      }
    }
    return prim;
  }

  std::string_view left_;
};

}  // namespace

UsdaFile read_usda(const std::string& text) {
  return UsdaReader(text).file();
}

}  // namespace flexkey::test
