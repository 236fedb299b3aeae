#include "flexkey/preview/images/tags.h"

#include <fmt/format.h>

#include <sstream>

namespace flexkey {
namespace {

/// The rest of the next word if it begins with `key`=.
std::optional<std::string> next_value(std::istream& words, const std::string& key) {
  std::string word;
  if (!(words >> word) || !word.starts_with(key) || word.size() <= key.size() || word[key.size()] != '=')
    return {};
  return word.substr(key.size() + 1);
}

template <class Number>
bool read_number(const std::optional<std::string>& text, Number& value) {
  if (!text) return false;
  std::istringstream stream(*text);
  return static_cast<bool>(stream >> value) && stream.eof();
}

}  // namespace

std::string describe(const PictureTags& tags) {
  return fmt::format("flexkey inputs={} frame={} time={} lambda={}", tags.inputs, tags.frame, tags.time,
                     tags.lambda);
}

std::optional<PictureTags> parse_tags(const std::string& line) {
  std::istringstream words(line);
  std::string maker;
  PictureTags tags;
  if (!(words >> maker) || maker != "flexkey") return {};
  const std::optional<std::string> inputs = next_value(words, "inputs");
  if (!inputs) return {};
  tags.inputs = *inputs;
  if (!read_number(next_value(words, "frame"), tags.frame)) return {};
  if (!read_number(next_value(words, "time"), tags.time)) return {};
  if (!read_number(next_value(words, "lambda"), tags.lambda)) return {};
  return tags;
}

}  // namespace flexkey
