#include "cli/build_id.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flexkey::cli {
namespace {

TEST(BuildId, IsWhatTheLinkerMadeOfTheProgram) {
  EXPECT_THAT(build_id(), testing::MatchesRegex("[0-9a-f]{16,}"));
  EXPECT_EQ(build_id(), build_id());
}

}  // namespace
}  // namespace flexkey::cli
