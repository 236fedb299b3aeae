#include "cli/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace flexkey::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string refusal_of(const std::string& frames) {
  try {
    parse_frames(frames, 100);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Frames, RangesStepsAndSingleFramesInOrder) {
  EXPECT_THAT(parse_frames("5-7,2,90-99x4", 100), ElementsAre(2, 5, 6, 7, 90, 94, 98));
  EXPECT_THAT(parse_frames("3,3-4,4", 100), ElementsAre(3, 4));
  EXPECT_TRUE(parse_frames("", 100).empty());
}

TEST(Frames, RefusesWhatIsNoFrame) {
  EXPECT_EQ(refusal_of("1,x"), "--frames '1,x': 'x' is not a frame, a range 0-30 or a stepped range 60-90x2");
  EXPECT_THAT(refusal_of("9-3"), HasSubstr("'9-3' is not a frame"));
  EXPECT_THAT(refusal_of("1-9x0"), HasSubstr("is not a frame"));
  EXPECT_THAT(refusal_of("1-"), HasSubstr("is not a frame"));
  EXPECT_THAT(refusal_of("-4"), HasSubstr("is not a frame"));
  EXPECT_EQ(refusal_of("90-100"), "--frames '90-100': '90-100' is past the shot's last frame, 99");
  EXPECT_THAT(refusal_of("99999999999"), HasSubstr("is not a frame"));
}

TEST(Overrides, SplitAtTheFirstEquals) {
  ShotOptions options;
  options.set = {"handles.tip.move.keys={1s: [0,0,1]}", "output=a=b.glb"};
  const std::vector<Override> overrides = options.overrides();
  EXPECT_EQ(overrides[0].key_path, "handles.tip.move.keys");
  EXPECT_EQ(overrides[0].value, "{1s: [0,0,1]}");
  EXPECT_EQ(overrides[1].value, "a=b.glb");
  options.set = {"lambda"};
  EXPECT_THROW(options.overrides(), UsageError);
}

TEST(Threads, HonourSlurm) {
  setenv("SLURM_CPUS_PER_TASK", "3", 1);
  EXPECT_EQ(thread_count(0), 3);
  EXPECT_EQ(thread_count(5), 5);
  setenv("SLURM_CPUS_PER_TASK", "many", 1);
  EXPECT_GE(thread_count(0), 1);
  unsetenv("SLURM_CPUS_PER_TASK");
}

TEST(Options, ChunksShareOutARowWithoutGapOrOverlap) {
  for (const std::size_t count : {7u, 8u, 100u})
    for (const std::size_t of : {1u, 3u, 7u}) {
      std::ptrdiff_t end = 0;
      for (std::size_t number = 1; number <= of; ++number) {
        const auto [first, last] = range_of({number, of}, count, "frame");
        EXPECT_EQ(first, end);
        end = last;
      }
      EXPECT_EQ(end, static_cast<std::ptrdiff_t>(count));
    }
  EXPECT_THROW(range_of({1, 9}, 8, "frame"), UsageError);
}

}  // namespace
}  // namespace flexkey::cli
