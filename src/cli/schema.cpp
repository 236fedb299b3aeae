#include "cli/schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/value_form.h"
#include "flexkey/timeline/easing.h"
#include "flexkey/timeline/keys.h"

namespace flexkey::cli {
namespace {

using json = nlohmann::ordered_json;

json any_of(std::vector<json> forms) {
  return forms.size() == 1 ? std::move(forms.front()) : json{{"anyOf", std::move(forms)}};
}

json reference(std::string_view name) {
  return {{"$ref", fmt::format("#/$defs/{}", name)}};
}

json forms_schema(const std::vector<ValueForm>& forms);

/// A number in a range, or a variable's name.
json number_schema(const ValueForm& form) {
  json number = {{"type", form.name == "whole" ? "integer" : "number"}};
  if (form.least) number[form.least->is_inside ? "minimum" : "exclusiveMinimum"] = form.least->value;
  if (form.most) number[form.most->is_inside ? "maximum" : "exclusiveMaximum"] = form.most->value;
  return any_of({std::move(number), reference("number-text")});
}

/// So many of them, or any number.
json list_schema(const ValueForm& form, int count) {
  json list = {{"type", "array"}, {"items", forms_schema(form.of)}};
  if (count > 0) list.update({{"minItems", count}, {"maxItems", count}});
  return any_of({std::move(list), reference("variable")});
}

json names_schema(const ValueForm& form) {
  return any_of(
      {{{"type", "object"}, {"additionalProperties", forms_schema(form.of)}}, reference("variable")});
}

/// {time: value} or [{at, value, ease}].
json keys_schema(const std::vector<ValueForm>& of) {
  const json value = forms_schema(of);
  json by_time = {{"type", "object"},
                  {"minProperties", 1},
                  {"propertyNames", reference("time-text")},
                  {"additionalProperties", value}};
  json listed = {{"type", "array"},
                 {"minItems", 1},
                 {"items", {{"allOf", {reference("key"), {{"properties", {{"value", value}}}}}}}}};
  return any_of({std::move(by_time), std::move(listed), reference("variable")});
}

json track_schema(const ValueForm& form) {
  return {{"allOf", {reference("track"), {{"properties", {{"keys", keys_schema(form.of)}}}}}}};
}

json form_schema(const ValueForm& form) {
  const std::string& name = form.name;
  if (name.starts_with('\'')) return {{"const", name.substr(1, name.size() - 2)}};
  if (name == "{track}") return track_schema(form);
  if (name.starts_with('{')) return reference(name.substr(1, name.size() - 2));
  if (name == "number" || name == "whole") return number_schema(form);
  if (name == "list") return list_schema(form, 0);
  if (name == "pair") return list_schema(form, 2);
  if (name == "triple") return list_schema(form, 3);
  if (name == "names") return names_schema(form);
  if (name == "keys") return keys_schema(form.of);
  if (name == "any") return json(true);
  return reference(name);
}

/// Words alone become one enumeration, which editors complete.
json forms_schema(const std::vector<ValueForm>& forms) {
  json words = json::array();
  std::vector<json> schemas;
  for (const ValueForm& form : forms) {
    json schema = form_schema(form);
    if (schema.is_object() && schema.contains("const")) {
      words.push_back(schema["const"]);
      if (schema["const"] == "off") words.push_back(false);  // which YAML 1.1 makes of it
    } else {
      schemas.push_back(std::move(schema));
    }
  }
  if (!words.empty()) {
    schemas.insert(schemas.begin(), json{{"enum", std::move(words)}});
    schemas.push_back(reference("variable"));
  }
  return any_of(std::move(schemas));
}

json mapping_schema(const MappingSpec& mapping) {
  json properties = json::object(), required = json::array();
  for (const KeySpec& key : mapping.keys) {
    const KeyForm form = parse_key_form(key.form);
    json schema = {{"description", key.about}};
    json forms = forms_schema(form.forms);
    if (forms.is_object()) schema.update(forms);
    properties[std::string(key.name)] = std::move(schema);
    if (form.is_required) required.push_back(key.name);
  }
  const bool takes_paths = mapping.name == "sweep";  // any key path, with a list of values
  json schema = {
      {"type", {"object", "string"}},
      {"pattern", "^\\$"},  // of a text, which can be a variable alone
      {"examples", {mapping.example}},
      {"properties", std::move(properties)},
      {"additionalProperties", takes_paths ? json{{"type", "array"}, {"minItems", 1}} : json(false)}};
  if (!required.empty()) schema["required"] = std::move(required);
  return schema;
}

json text_schema(std::string_view description, std::string_view pattern) {
  return {{"description", description}, {"type", "string"}, {"pattern", pattern}};
}

/// A text, or a plain number where the YAML says one.
json unit_schema(std::string_view description, std::string_view pattern) {
  return {{"description", description}, {"type", {"number", "string"}}, {"pattern", pattern}};
}

/// The values that are no mapping of keys.
json value_schemas() {
  constexpr std::string_view number = "[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?";
  constexpr std::string_view name = "[^-+.$\\d\\s][^-+$\\s]*";
  const json numbers = {{"type", "array"},
                        {"minItems", 3},
                        {"maxItems", 3},
                        {"items", any_of({{{"type", "number"}}, reference("number-text")})}};
  json easings = json::array();
  for (const NamedEasing& easing : named_easings()) easings.push_back(easing.name);
  return {
      {"variable", text_schema("a variable under 'vars'", "^\\$.")},
      {"number-text",
       text_schema("a number, or a variable's name", fmt::format("^(\\$?{}|{})$", name, number))},
      {"text", {{"type", {"string", "number", "boolean"}}}},
      {"path", text_schema("a path", "^.")},
      {"time-text", text_schema("seconds (1.5, 1.5s), frames (36f), or a name under 'times' (hit, hit+4f)",
                                fmt::format("^\\$?({0}[sf]?|{1}(\\s*[-+]\\s*{0}[sf]?)?)$", number, name))},
      {"time", any_of({{{"type", "number"}, {"minimum", 0}}, reference("time-text")})},
      {"angle",
       text_schema("with its unit, deg or rad", fmt::format("^({}\\s*(deg|rad)|\\$?{})$", number, name))},
      {"length", unit_schema("mesh units, or % of the diagonal or extent",
                             fmt::format("^({}\\s*%?|\\$?{})$", number, name))},
      {"vector", any_of({numbers, reference("variable")})},
      {"point", any_of({numbers, text_schema("a name under 'points'", "^.")})},
      {"axis", any_of({{{"enum", {"x", "y", "z", "-x", "-y", "-z"}}}, numbers, reference("variable")})},
      {"switch", {{"enum", {true, false, "on", "off", "true", "false", "yes", "no"}}}},
      {"range", text_schema("a range such as 12-40, or 0-30x2 for every other frame", "^[\\d\\s,x-]+$|^\\$")},
      {"ease", any_of({{{"enum", std::move(easings)}},
                       {{"description", "[x1, y1, x2, y2] of a CSS cubic-bezier"},
                        {"type", "array"},
                        {"minItems", 4},
                        {"maxItems", 4}},
                       reference("variable")})},
  };
}

}  // namespace

std::string timeline_schema() {
  json definitions = value_schemas();
  for (const MappingSpec* mapping : all_mappings()) {
    if (mapping->name != "shot" && mapping->name != "curve")
      definitions[std::string(mapping->name)] = mapping_schema(*mapping);
  }
  definitions["curve"] =
      any_of({mapping_schema(curve_keys), text_schema("rest, or a name under 'paths'", "^.")});
  json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                 {"title", "flexkey timeline"},
                 {"description", "One shot: a mesh, what leads it over time, and the files to write"}};
  schema.update(mapping_schema(shot_keys));
  schema["type"] = "object";
  schema.erase("pattern");
  schema["$defs"] = std::move(definitions);
  return schema.dump(2, ' ', false, json::error_handler_t::replace);
}

int run_schema() {
  print_result(fmt::format("{}\n", timeline_schema()));
  return done;
}

}  // namespace flexkey::cli
