// Every broken timeline of the corpus gives one error, at its place and with its words.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "timeline/parsing.h"

namespace flexkey {
namespace {

using testing::HasSubstr;

constexpr std::string_view marker = "▶";

struct BrokenTimeline {
  int line = 0;  // of the corpus
  std::vector<std::string> words;
  std::string text;
  Mark where;  // of the marker, which is left out of the text
};

std::vector<std::string> parted(std::string text) {
  std::vector<std::string> parts;
  for (std::size_t at = text.find(" && "); at != std::string::npos; at = text.find(" && ")) {
    parts.push_back(text.substr(0, at));
    text.erase(0, at + 4);
  }
  parts.push_back(text);
  return parts;
}

int characters_in(std::string_view text) {
  return static_cast<int>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// Adds a line of a case, and notes where the marker stands in it.
void add_line(BrokenTimeline& broken, std::string line) {
  if (line == "@base") line = "mesh: bar.obj\nhandles:\n  base: {select: {axis: z, below: 1%}}";
  if (line == "@tip") line = "mesh: bar.obj\nhandles:\n  tip:\n    select: {axis: z, above: 99%}";
  if (const std::size_t at = line.find(marker); at != std::string::npos) {
    broken.where.line = 1 + static_cast<int>(std::count(broken.text.begin(), broken.text.end(), '\n'));
    broken.where.column = 1 + characters_in(std::string_view(line).substr(0, at));
    line.erase(at, marker.size());
  }
  broken.text += line + "\n";
}

std::vector<BrokenTimeline> corpus() {
  std::vector<BrokenTimeline> cases;
  std::ifstream file(FLEXKEY_CORPUS);
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.starts_with("== ")) {
      cases.push_back({number, parted(line.substr(3)), "", {}});
    } else if (!cases.empty()) {
      add_line(cases.back(), line);
    }
  }
  return cases;
}

std::vector<Diagnostic> errors_in(const std::string& text) {
  const Sources sources = files({{"bad.csv", "time, tx, ty, tz\n0, x, 0, 0\n"}});
  try {
    parse_shot(text, "shot.yaml", {}, sources);
  } catch (const TimelineError& error) {
    return error.diagnostics();
  }
  return {};
}

TEST(Corpus, HasManyCases) {
  EXPECT_GE(corpus().size(), 120u);
}

TEST(Corpus, EveryMistakeIsOneErrorAtItsPlaceWithItsWords) {
  for (const BrokenTimeline& broken : corpus()) {
    SCOPED_TRACE("line " + std::to_string(broken.line) + " of the corpus:\n" + broken.text);
    const std::vector<Diagnostic> errors = errors_in(broken.text);
    std::string all;
    for (const Diagnostic& error : errors) all += format_diagnostic("shot.yaml", error) + "\n";
    SCOPED_TRACE(all);
    EXPECT_EQ(errors.size(), 1u);
    if (errors.empty()) continue;
    EXPECT_EQ(errors[0].where.line, broken.where.line);
    EXPECT_EQ(errors[0].where.column, broken.where.column);
    for (const std::string& word : broken.words) EXPECT_THAT(errors[0].message, HasSubstr(word));
  }
}

}  // namespace
}  // namespace flexkey
