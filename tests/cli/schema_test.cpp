// The parser, the schema and the reference timeline say the same.
#include "cli/schema.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/timeline_files.h"
#include "cli/value_form.h"
#include "cli/work_folder.h"
#include "flexkey/mesh/read_file.h"
#include "flexkey/timeline/keys.h"
#include "flexkey/timeline/node.h"
#include "flexkey/timeline/parse.h"
#include "flexkey/timeline/source_text.h"

namespace flexkey {
namespace {

namespace fs = std::filesystem;
using cli::ValueForm;
using nlohmann::json;
using testing::HasSubstr;

const fs::path timelines = fs::path(FLEXKEY_SOURCE) / "timelines";

const MappingSpec& mapping_named(const std::string& name) {
  for (const MappingSpec* mapping : all_mappings())
    if (mapping->name == name) return *mapping;
  throw std::invalid_argument("no mapping " + name);
}

const KeySpec* key_of(const MappingSpec& mapping, const std::string& name) {
  for (const KeySpec& key : mapping.keys)
    if (key.name == name) return &key;
  return nullptr;
}

/// A key where the reference has it.
struct Shown {
  std::string key_path;
  std::string key;  // "handle.select"
  std::vector<ValueForm> forms;
};

/// Goes through the reference by the forms of its keys.
class Walk {
 public:
  explicit Walk(const Node& root) { enter_mapping(root, "shot", ""); }
  std::vector<Shown> shown;

 private:
  void enter_mapping(const Node& node, const std::string& name, const std::string& path) {
    for (const Entry& entry : node.entries) {
      const KeySpec* key = key_of(mapping_named(name), entry.key.text);
      if (key == nullptr) continue;  // a key path of a sweep
      const std::string below = path.empty() ? entry.key.text : path + "." + entry.key.text;
      const std::vector<ValueForm> forms = cli::parse_key_form(key->form).forms;
      shown.push_back({below, name + "." + std::string(key->name), forms});
      for (const ValueForm& form : forms) enter(entry.value, form, below);
    }
  }

  void enter(const Node& node, const ValueForm& form, const std::string& path) {
    const std::string& name = form.name;
    if (name == "curve" || name == "{track}") {
      if (node.kind == Node::Kind::map) enter_mapping(node, name == "curve" ? name : "track", path);
      for (const Entry& entry : node.entries)  // the values of its keys
        if (name == "{track}" && entry.key.text == "keys") enter_keys(entry.value, form.of, path + ".keys");
    } else if (name.starts_with('{') && is_like(node, name.substr(1, name.size() - 2))) {
      enter_mapping(node, name.substr(1, name.size() - 2), path);
    } else if (name == "keys") {
      enter_keys(node, form.of, path);
    } else if (name == "names" || name == "list" || name == "pair") {
      enter_each(node, form.of, path);
    }
  }

  /// Whether a mapping's keys are those of this one.
  static bool is_like(const Node& node, const std::string& name) {
    return node.kind == Node::Kind::map &&
           std::all_of(node.entries.begin(), node.entries.end(), [&](const Entry& entry) {
             return key_of(mapping_named(name), entry.key.text) != nullptr;
           });
  }

  void enter_keys(const Node& node, const std::vector<ValueForm>& of, const std::string& path) {
    enter_each(node, of, path);
    for (std::size_t k = 0; k < node.items.size(); ++k)
      enter_mapping(node.items[k], "key", path + "." + std::to_string(k));
  }

  void enter_each(const Node& node, const std::vector<ValueForm>& of, const std::string& path) {
    for (const ValueForm& form : of) {
      for (std::size_t k = 0; k < node.items.size(); ++k)
        enter(node.items[k], form, path + "." + std::to_string(k));
      for (const Entry& entry : node.entries) enter(entry.value, form, path + "." + entry.key.text);
    }
  }
};

class Schema : public test::WorkFolder {
 protected:
  const std::string text_ = read_file(timelines / "reference.yaml");

  std::vector<Shown> shown() const {
    Findings findings;
    return Walk(parse_yaml(text_, findings)).shown;
  }

  /// What the parser says of the reference with one change.
  std::string errors_with(const std::string& key_path, const std::string& value) const {
    cli::TimelineFiles files{timelines, {}, {}};
    try {
      parse_shot(text_, "reference.yaml", {{key_path, value}}, cli::sources_of(files));
    } catch (const TimelineError& error) {
      return error.what();
    }
    return {};
  }

  /// What a validator from a package says of a timeline; empty: it is valid.
  std::string validate(const std::string& timeline) const {
    write("schema.json", cli::timeline_schema());
    write("timeline.yaml", timeline);
    write("validate.py",
          "import json, jsonschema, yaml\n"
          "schema = json.load(open('schema.json'))\n"
          "jsonschema.Draft202012Validator.check_schema(schema)\n"
          "document = json.loads(json.dumps(yaml.safe_load(open('timeline.yaml'))))\n"
          "for error in jsonschema.Draft202012Validator(schema).iter_errors(document):\n"
          "    print(list(error.absolute_path), error.message[:300])\n");
    const std::string run = fmt::format("cd '{}' && python3 validate.py > found.txt 2>&1", folder().string());
    EXPECT_EQ(std::system(run.c_str()), 0);
    return read_file(folder() / "found.txt");
  }
  static bool has_validator() { return std::system("python3 -c 'import jsonschema, yaml' 2>/dev/null") == 0; }
};

TEST_F(Schema, HasEveryKeyOfTheTableAndSoHasTheReference) {
  const json schema = json::parse(cli::timeline_schema());
  std::set<std::string> in_reference;
  for (const Shown& one : shown()) in_reference.insert(one.key);
  in_reference.insert("animation.merge_into");  // instead of 'name', in a comment
  for (const MappingSpec* mapping : all_mappings()) {
    const std::string name(mapping->name);
    const json& definition = name == "shot"    ? schema
                             : name == "curve" ? schema["$defs"]["curve"]["anyOf"][0]
                                               : schema["$defs"][name];
    EXPECT_EQ(definition["properties"].size(), mapping->keys.size()) << name;
    for (const KeySpec& key : mapping->keys) {
      EXPECT_EQ(definition["properties"][std::string(key.name)]["description"], key.about);
      EXPECT_TRUE(in_reference.contains(name + "." + std::string(key.name))) << name << "." << key.name;
    }
  }
  EXPECT_THAT(text_, HasSubstr("merge_into: Walk"));
}

/// A key that no reader reads would take anything.
TEST_F(Schema, TheParserReadsEveryKeyOfTheReference) {
  const std::set<std::string> takes_anything{"shot.vars"};
  ASSERT_EQ(errors_with("fps", "24"), "");
  for (const Shown& one : shown()) {
    if (takes_anything.contains(one.key)) continue;
    EXPECT_NE(errors_with(one.key_path, "[{zzz: [zzz]}, zzz]"), "") << one.key_path;
  }
}

TEST_F(Schema, TheParserTakesEveryWordAndNoOther) {
  for (const Shown& one : shown()) {
    std::vector<std::string> words;
    for (const ValueForm& form : one.forms)
      if (form.name.starts_with('\'')) words.push_back(form.name.substr(1, form.name.size() - 2));
    const bool words_alone = words.size() == one.forms.size();
    for (const std::string& word : words) {
      const std::string errors = errors_with(one.key_path, word);
      EXPECT_EQ(errors.find("'" + word + "'; "), std::string::npos) << errors;
    }
    const std::string told = errors_with(one.key_path, "zzz");
    EXPECT_TRUE(!words_alone || !told.empty()) << one.key_path;
    const std::size_t list = told.find("; known are ");
    if (!words_alone || list == std::string::npos) continue;
    for (const std::string& word : words) EXPECT_THAT(told.substr(list), HasSubstr(word)) << one.key_path;
    EXPECT_EQ(std::count(told.begin() + static_cast<std::ptrdiff_t>(list), told.end(), ','),
              static_cast<std::ptrdiff_t>(words.size()) - 1)
        << one.key_path << ": " << told;
  }
}

TEST_F(Schema, TakesTheReferenceAndEverySample) {
  if (!has_validator()) GTEST_SKIP() << "python3-jsonschema and python3-yaml are not installed";
  for (const fs::directory_entry& entry : fs::directory_iterator(timelines)) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_EQ(validate(read_file(entry.path())), "") << entry.path();
  }
}

TEST_F(Schema, RefusesMistakes) {
  if (!has_validator()) GTEST_SKIP() << "python3-jsonschema and python3-yaml are not installed";
  const std::string base = "mesh: a.obj\nhandles: {tip: {select: {axis: z, above: 99%}}}\n";
  EXPECT_EQ(validate(base), "");
  for (const std::string line :
       {"lamda: 1", "lambda: 1.2", "fps: 0", "loop: cicle", "solver: {system: direkt}",
        "output: {gltf: {pth: a}}", "points: {a: [0, 1]}", "lambda: {keys: {0s: 2}}", "sweep: {lambda: 1}",
        "ease: easy"})
    EXPECT_NE(validate(base + line + "\n"), "") << line;
  EXPECT_NE(validate("mesh: a.obj\n"), "");
  EXPECT_NE(validate("mesh: a.obj\nhandles: {tip: {rotate: {axis: z, keys: {0s: 0deg}}}}\n"), "");
}

TEST_F(Schema, IsPrinted) {
  const test::ProgramResult result = run({"schema"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output, cli::timeline_schema() + "\n");
  EXPECT_EQ(json::parse(result.output)["$schema"], "https://json-schema.org/draft/2020-12/schema");
}

}  // namespace
}  // namespace flexkey
