#include "flexkey/mesh/ply_header.h"

#include <fmt/format.h>

#include <limits>
#include <map>
#include <utility>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/text_words.h"

namespace flexkey {
namespace {

using Kind = PlyType::Kind;

const std::map<std::string_view, PlyType> types = {
    {"char", {Kind::whole, 1}},      {"int8", {Kind::whole, 1}},       {"uchar", {Kind::positive, 1}},
    {"uint8", {Kind::positive, 1}},  {"short", {Kind::whole, 2}},      {"int16", {Kind::whole, 2}},
    {"ushort", {Kind::positive, 2}}, {"uint16", {Kind::positive, 2}},  {"int", {Kind::whole, 4}},
    {"int32", {Kind::whole, 4}},     {"uint", {Kind::positive, 4}},    {"uint32", {Kind::positive, 4}},
    {"float", {Kind::floating, 4}},  {"float32", {Kind::floating, 4}}, {"double", {Kind::floating, 8}},
    {"float64", {Kind::floating, 8}}};

PlyType read_type(TextWords& words) {
  const std::string_view word = words.next("a type");
  const auto found = types.find(word);
  if (found == types.end()) words.fail(fmt::format("unknown type '{}'", word.substr(0, 32)));
  return found->second;
}

PlyFormat read_format(TextWords& words) {
  const std::string_view word = words.next("a format");
  const std::string_view version = words.next("the format's version");
  if (version != "1.0") words.fail(fmt::format("version {} is not known, 1.0 is", version.substr(0, 32)));
  if (word == "ascii") return PlyFormat::text;
  if (word == "binary_little_endian") return PlyFormat::little_endian;
  if (word == "binary_big_endian") return PlyFormat::big_endian;
  words.fail(fmt::format("unknown format '{}'", word.substr(0, 32)));
}

PlyProperty read_property(TextWords& words) {
  PlyProperty property;
  TextWords ahead = words;
  property.is_list = ahead.next("a type") == "list";
  if (property.is_list) {
    words = ahead;
    property.count_type = read_type(words);
    if (property.count_type.kind == Kind::floating) words.fail("a list has a whole number of items");
  }
  property.type = read_type(words);
  property.name = words.next("the name of a property");
  return property;
}

PlyElement read_element(TextWords& words) {
  PlyElement element;
  element.name = words.next("the name of an element");
  element.count = static_cast<std::size_t>(
      words.whole(fmt::format("the count of '{}'", element.name), 0, std::numeric_limits<int>::max()));
  return element;
}

}  // namespace

PlyHeader read_ply_header(std::string_view bytes, const std::string& name) {
  TextWords words(bytes, name, TextWords::Comments::none);
  if (words.at_end() || words.next("'ply'") != "ply") words.fail("a PLY file begins with 'ply'");
  PlyHeader header;
  bool has_format = false;
  for (;;) {
    const std::string_view keyword = words.next("'end_header'");
    if (keyword == "end_header") break;
    if (keyword == "format") {
      header.format = read_format(words);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(read_element(words));
    } else if (keyword == "property") {
      if (header.elements.empty()) words.fail("a property stands before any element");
      header.elements.back().properties.push_back(read_property(words));
    } else if (keyword != "comment" && keyword != "obj_info") {
      words.fail(fmt::format("'{}' has no meaning in the header of a PLY", keyword.substr(0, 32)));
    }
    words.rest_of_line();
  }
  if (!has_format) words.fail("the header names no format");
  // One end of line, as the file writes it: what follows is data.
  std::size_t data = bytes.size() - words.bytes_left();
  if (bytes.substr(data).starts_with('\r')) ++data;
  if (bytes.substr(data).starts_with('\n')) ++data;
  header.bytes = data;
  header.lines = words.line();
  return header;
}

}  // namespace flexkey
