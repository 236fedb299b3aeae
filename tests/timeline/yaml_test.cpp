// What YAML itself allows and forbids: encodings, syntax, anchors, merge keys, and bounds against hostile
// files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "flexkey/timeline/node.h"
#include "flexkey/timeline/source_text.h"
#include "timeline/parsing.h"

namespace flexkey {
namespace {

using testing::HasSubstr;

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

std::string numbered(std::string prefix, int number) {
  return prefix.append(std::to_string(number));
}

/// "line:column: message" of a text that cannot be read, or what else is wrong with it.
std::string failure_of(const std::string& text) {
  const std::string errors = errors_of(text);
  const std::string prefix = "shot.yaml:";
  return errors.starts_with(prefix) ? errors.substr(prefix.size()) : errors;
}

TEST(Encoding, ByteOrderMarkAndLineEndings) {
  const std::string text = with_base("fps: 30\nlambda: 1.2\n");
  for (const char* line_break : {"\n", "\r\n", "\r"}) {
    std::string changed = "\xEF\xBB\xBF";
    for (const char c : text) changed += c == '\n' ? line_break : std::string(1, c);
    EXPECT_THAT(failure_of(changed), HasSubstr("5:9: error: lambda 1.2 is outside"))
        << testing::PrintToString(line_break);
  }
}

TEST(Encoding, ColumnsCountCharacters) {
  EXPECT_THAT(failure_of("mesh: bar.obj\nhandles: {näse: {select: {group: a}, rotat: 1}}\n"),
              HasSubstr("2:38: error: unknown key 'rotat' in handle 'näse'"));
}

TEST(Encoding, MustBeUtf8) {
  EXPECT_EQ(failure_of("mesh: a.obj\n# caf\xE9\n"),
            "2:6: error: the file is not UTF-8 (byte 0xE9); save it as UTF-8");
  EXPECT_EQ(failure_of("# é \xFF"), "1:5: error: the file is not UTF-8 (byte 0xFF); save it as UTF-8");
  EXPECT_THAT(failure_of("a: \xC0\xAF"), HasSubstr("not UTF-8")) << "overlong";
  EXPECT_THAT(failure_of("a: \xED\xA0\x80"), HasSubstr("not UTF-8")) << "surrogate";
  EXPECT_THAT(failure_of("a: \xF4\x90\x80\x80"), HasSubstr("not UTF-8")) << "beyond U+10FFFF";
  EXPECT_THAT(failure_of("a: \xE2\x82"), HasSubstr("not UTF-8")) << "cut off";
  EXPECT_THAT(failure_of(std::string("\xFF\xFEm\0", 4)), HasSubstr("1:1: error: the file is not UTF-8"))
      << "UTF-16";
}

TEST(Encoding, NoControlCharacters) {
  EXPECT_EQ(failure_of(std::string("mesh: a\0b", 9)),
            "1:8: error: a control character (byte 0x00) cannot be in a timeline");
  EXPECT_THAT(failure_of("a: \x1B[31m"), HasSubstr("1:4: error: a control character (byte 0x1B)"));
}

TEST(Encoding, MessagesStayOneShortLine) {
  const std::string error = failure_of(with_base("fps: \"a\\nb\\e" + repeated("é", 5000) + "\"\n"));
  EXPECT_EQ(error.find('\n'), std::string::npos);
  EXPECT_EQ(error.find('\x1B'), std::string::npos);
  EXPECT_LT(error.size(), 1000u);
  EXPECT_NO_THROW(SourceText{error}) << "still UTF-8";
}

TEST(Document, EmptyTexts) {
  for (const char* text : {"", "\n\n", "# a comment\n", "---\n", "~", "   "}) {
    EXPECT_EQ(failure_of(text), "1:1: error: the timeline is empty") << text;
  }
}

TEST(Document, IsOneMapping) {
  EXPECT_EQ(failure_of("- mesh\n- handles\n"),
            "1:1: error: a timeline must be a mapping such as {mesh: bar.obj, handles: {…}}, not a list");
  EXPECT_THAT(failure_of("bar.obj\n"), HasSubstr("not 'bar.obj'"));
  EXPECT_EQ(failure_of(with_base("---\nfps: 24\n")),
            "4:1: error: a timeline is one document; a second one starts here");
  EXPECT_EQ(failure_of("- a\nmesh: b\n"), "2:1: error: this belongs to no key; check its indentation");
  EXPECT_EQ(errors_of("---\n" + with_base("...\n")), "") << "markers around one document";
}

TEST(Syntax, SaysWhatToChange) {
  EXPECT_EQ(failure_of("handles:\n\tbase: 1\n"), "2:1: error: a tab cannot indent a line; use spaces");
  EXPECT_EQ(failure_of("handles:\n  base: 1\n  \ttip: 2\n"),
            "3:3: error: a tab cannot indent a line; use spaces");
  EXPECT_EQ(errors_of(with_base("fps:\t24\n")), "") << "a tab between key and value is fine";
  EXPECT_EQ(failure_of("a: [1, 2\nb: 3\n"),
            "2:2: error: a ',' or ']' is missing here; the list began at 1:4");
  EXPECT_EQ(failure_of("a: {b: 1 c: 2}\n"),
            "1:11: error: a ',' or '}' is missing here; the mapping began at 1:4");
  EXPECT_EQ(failure_of("a: 1\n]\n"), "2:1: error: this bracket closes nothing that is open");
  EXPECT_THAT(failure_of("fps: 24\n lambda: 1\n"), HasSubstr("2:8: error: a ':' cannot stand here"));
  EXPECT_EQ(failure_of("a: @x\n"), "1:4: error: this character cannot begin a value; quote the text");
  EXPECT_EQ(failure_of("a: 'it\nb: 2\n"), "1:4: error: this quote is never closed");
  EXPECT_EQ(failure_of("a: &x \"it\\\"\nb: 2\n"), "1:7: error: this quote is never closed");
  EXPECT_EQ(errors_of(with_base("output: 'it''s.glb'\n")), "");
  EXPECT_EQ(failure_of("a: !mesh b\n"), "1:4: error: the tag '!mesh' has no meaning in a timeline");
  EXPECT_EQ(errors_of(with_base("fps: !!float 24\n")), "");
  EXPECT_THAT(failure_of("a: \"\\q\"\n"), HasSubstr("1:7: error: not valid YAML: unknown escape character"));
}

TEST(Keys, StandOnce) {
  EXPECT_EQ(failure_of(with_base("lambda: 0\nfps: 24\nlambda: 1\n")), "6:1: error: duplicate key 'lambda'");
  EXPECT_EQ(failure_of("mesh: pig.glb\n" + repeated("\n", 8) +
                       "handles: {a: {select: {group: leg}, move: {}, 'move': {}}}\n"),
            "10:43: error: 'move' of handle 'a' needs 'keys'\n"
            "shot.yaml:10:47: error: duplicate key 'move'");
}

TEST(Keys, AreSingleWords) {
  EXPECT_EQ(failure_of(with_base("? [1, 2]\n: 3\n")), "4:3: error: a key must be a single word");
  EXPECT_EQ(failure_of(with_base("vars: {{a: 1}: 3, : 4}\n")),
            "4:8: error: a key must be a single word\nshot.yaml:4:19: error: a key must be a single word");
}

TEST(Keys, AloneBetweenCommasWereMeantAsAList) {
  EXPECT_EQ(failure_of(with_base(
                "output: {gltf: a.glb, preview: {frames: 1-30,47,60-90x2, dir: a}}\nduration: 9s\n")),
            "4:46: error: '47' has no value: a comma inside { } begins a new key; write a list, "
            "frames: [1-30, 47, 60-90x2], or quotes, frames: \"1-30,47,60-90x2\"");
  EXPECT_EQ(failure_of(with_base("roi: {vertices: 0, 12-40}\n")),
            "4:20: error: '12-40' has no value: a comma inside { } begins a new key; write a list, "
            "vertices: [0, 12-40], or quotes, vertices: \"0,12-40\"");
  EXPECT_EQ(failure_of(with_base("vars: {a}\n")), "4:8: error: 'a' has no value");
  EXPECT_EQ(failure_of(with_base("vars: {a:1}\n")), "4:8: error: 'a:1' needs a space after its ':'");
  EXPECT_EQ(failure_of(with_base("roi: {group: }\n")), "4:7: error: 'group' has no value");
}

TEST(Anchors, AliasesRepeatValues) {
  const Shot shot = parse(
      "mesh: a.obj\nhandles:\n  a: &a {select: {group: &g leg}}\n  b: *a\n  c: {select: {group: *g}}\n");
  ASSERT_EQ(shot.handles.size(), 3u);
  for (const Handle& handle : shot.handles) EXPECT_EQ(std::get<SelectGroup>(handle.select.kind).name, "leg");
}

TEST(Anchors, MergeKeysGiveWhatIsNotThere) {
  const Shot shot = parse(
      "mesh: a.obj\n"
      "handles:\n"
      "  a: &a {select: {group: leg}, pivot: [1, 0, 0], move: {keys: {0s: [0, 0, 0]}}}\n"
      "  b: {pivot: [2, 0, 0], <<: *a}\n"
      "  c: &c {<<: [{pivot: [3, 0, 0]}, *a], select: {group: arm}}\n"
      "  d: {<<: *c}\n");
  EXPECT_EQ(shot.handles.at(1).pivot->x(), 2) << "explicit keys win";
  EXPECT_EQ(shot.handles.at(1).move.size(), 1u);
  EXPECT_EQ(shot.handles.at(2).pivot->x(), 3) << "of a list, the first wins";
  EXPECT_EQ(std::get<SelectGroup>(shot.handles.at(2).select.kind).name, "arm");
  EXPECT_EQ(std::get<SelectGroup>(shot.handles.at(3).select.kind).name, "arm") << "merges of merges";
}

TEST(Anchors, Errors) {
  EXPECT_EQ(failure_of("a: *nowhere\n"), "1:4: error: this alias names no anchor above it");
  EXPECT_EQ(failure_of("a: &a [*a]\n"), "1:8: error: this alias stands inside the value that it names");
  EXPECT_EQ(failure_of("a: &a {b: {c: [*a]}}\n"),
            "1:16: error: this alias stands inside the value that it names");
  EXPECT_EQ(failure_of("a: &a {<<: *a}\n"), "1:12: error: this alias stands inside the value that it names");
  EXPECT_EQ(failure_of(with_base("vars: {<<: 3}\n")), "4:12: error: '<<' merges mappings, not '3'");
  EXPECT_EQ(failure_of(with_base("vars: {<<: {}, <<: {}}\n")), "4:16: error: duplicate key '<<'");
}

TEST(Anchors, AMistakeInAnAliasIsReportedOnce) {
  EXPECT_EQ(failure_of("mesh: a.obj\nhandles:\n  a: {select: &s {axis: q, above: 1}}\n  b: {select: *s}\n"),
            "3:25: error: the axis of a selection is x, y or z, not 'q'");
}

TEST(Bounds, NestingIsAtMost64Deep) {
  const auto nested = [](int depth) {
    return "vars: {a: " + repeated("[", depth) + repeated("]", depth) + "}\n";
  };
  EXPECT_EQ(errors_of(with_base(nested(62))), "");
  EXPECT_EQ(failure_of(with_base(nested(63))), "4:73: error: values are nested more than 64 deep");
  for (const char* opening : {"[", "{a: ", "- ", "? ", "[? "}) {
    EXPECT_THAT(failure_of(repeated(opening, 100'000)), HasSubstr("nested more than 64 deep")) << opening;
  }
  std::string lines;
  for (int depth = 0; depth < 1000; ++depth) lines += repeated(" ", depth) + "a:\n";
  EXPECT_THAT(failure_of(lines), HasSubstr("65:65: error: values are nested more than 64 deep"));
}

TEST(Bounds, NestingThroughAliasesToo) {
  const std::string deep = "a: &a " + repeated("[", 40) + repeated("]", 40) + "\n";
  EXPECT_EQ(failure_of(deep + "b: " + repeated("[", 30) + "*a" + repeated("]", 30) + "\n"),
            "2:34: error: with its aliases, values are nested more than 64 deep");
}

TEST(Bounds, AliasBombsEndAtTheFirstAliasTooMany) {
  std::string bomb = "a0: &a0 [x,x,x,x,x,x,x,x,x,x]\n";
  for (int i = 1; i <= 60; ++i) {
    const std::string alias = numbered("*a", i - 1), name = numbered("a", i);
    bomb.append(name).append(": &").append(name).append(" [");
    bomb.append(repeated(alias + ",", 9)).append(alias).append("]\n");
  }
  EXPECT_EQ(failure_of(bomb), "5:38: error: with its aliases the timeline has more than 100000 values");
}

TEST(Bounds, MergeBombsToo) {
  std::string bomb = "a: &a {k0: 1";
  for (int i = 1; i < 1000; ++i) bomb.append(numbered(", k", i)).append(": 1");
  bomb += "}\nb: {<<: [" + repeated("*a, ", 10'000) + "*a]}\n";
  EXPECT_THAT(failure_of(bomb), HasSubstr("with its aliases the timeline has more than 100000 values"));
}

TEST(Bounds, ValuesAndBytes) {
  EXPECT_EQ(errors_of(with_base("vars: {a: [" + repeated("1,", 99'000) + "]}\n")), "");
  EXPECT_THAT(failure_of(with_base("vars: {a: [" + repeated("1,", 100'000) + "]}\n")),
              HasSubstr("error: the timeline has more than 100000 values"));
  EXPECT_EQ(failure_of(std::string((4 << 20) + 1, ' ')), "1:1: error: the timeline is larger than 4 MiB");
}

TEST(Bounds, ManyMistakesWithManyNamesAreReportedSoon) {
  std::string points = "points: {", path = "roi: {path: [";
  for (int i = 0; i < 15'000; ++i) points.append(numbered("point_", i)).append(": [0, 0, 0], ");
  for (int i = 0; i < 10'000; ++i) path.append(numbered("pint_", i)).append(", ");
  const std::string errors = failure_of(with_base(points + "z: [0, 0, 0]}\n" + path + "z]}\n"));
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 9999);
}

}  // namespace
}  // namespace flexkey
