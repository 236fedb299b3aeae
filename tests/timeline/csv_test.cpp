#include "flexkey/timeline/csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

using testing::ElementsAre;

std::vector<std::string> cells(const std::string& line) {
  return csv_rows(line).at(0).cells;
}

TEST(Csv, PartsCellsAtCommas) {
  EXPECT_THAT(cells("a, b ,c"), ElementsAre("a", "b", "c"));
  EXPECT_THAT(cells("a,,"), ElementsAre("a", "", ""));
  EXPECT_THAT(cells("alone"), ElementsAre("alone"));
}

TEST(Csv, QuotesKeepCommasAndQuotes) {
  EXPECT_THAT(cells(R"("[0, 0, 1]", "say ""yes""" ,x)"), ElementsAre("[0, 0, 1]", "say \"yes\"", "x"));
  EXPECT_THAT(cells(R"("")"), ElementsAre(""));
}

TEST(Csv, LeavesOutEmptyLinesAndComments) {
  const std::vector<CsvRow> rows = csv_rows("\xEF\xBB\xBFkey\r\n\r\n# why\r\n1\r\n");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_THAT(rows[0].cells, ElementsAre("key"));
  EXPECT_EQ(rows[1].line, 4);
}

TEST(Csv, RefusesQuotesThatDoNotClose) {
  EXPECT_THROW(csv_rows("a\n\"b"), InputError);
  EXPECT_THROW(csv_rows("\"a\" b"), InputError);
}

}  // namespace
}  // namespace flexkey
