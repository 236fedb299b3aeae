// output.cache, output.frames and output.usd.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "flexkey/timeline/frame_pattern.h"
#include "timeline/parsing.h"

namespace flexkey {
namespace {

using Form = CacheOutput::Form;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

/// Form and path of each, in the order of their keys.
std::vector<std::pair<Form, std::string>> caches_of(const std::string& output) {
  std::vector<std::pair<Form, std::string>> caches;
  for (const CacheOutput& cache : parse(with_base("output: " + output + "\n")).caches)
    caches.emplace_back(cache.form, cache.path);
  return caches;
}

/// The errors of an output that stands in line 4 from column 9.
std::string errors_of_output(const std::string& output) {
  return errors_of(with_base("output: " + output + "\n"));
}

TEST(CacheOutputs, ArePathsMappingsOrLists) {
  EXPECT_THAT(caches_of("a.glb"), IsEmpty());
  EXPECT_THAT(caches_of("{cache: a.pc2}"), ElementsAre(Pair(Form::pc2, "a.pc2")));
  EXPECT_THAT(caches_of("{cache: {path: a.MDD}}"), ElementsAre(Pair(Form::mdd, "a.MDD")));
  EXPECT_THAT(caches_of("{usd: b/a.usda, frames: [f/%04d.obj, {path: g/%d.npz}], cache: [a.pc2, a.mdd]}"),
              ElementsAre(Pair(Form::pc2, "a.pc2"), Pair(Form::mdd, "a.mdd"), Pair(Form::obj, "f/%04d.obj"),
                          Pair(Form::npz, "g/%d.npz"), Pair(Form::usda, "b/a.usda")));
}

TEST(CacheOutputs, NeedNoGltf) {
  const Shot shot = parse(with_base("output: {cache: a.pc2}\n"));
  EXPECT_EQ(shot.gltf.path, "");
  EXPECT_EQ(shot.caches.at(0).where.line, 4);
  EXPECT_EQ(shot.caches.at(0).where.column, 17);
}

TEST(CacheOutputs, NameFilesOfTheirKind) {
  EXPECT_EQ(errors_of_output("{cache: a.abc}"),
            "shot.yaml:4:17: error: 'cache' names a file that ends in '.pc2' or '.mdd', not 'a.abc'");
  EXPECT_EQ(errors_of_output("{cache: {path: a}}"),
            "shot.yaml:4:24: error: 'cache' names a file that ends in '.pc2' or '.mdd', not 'a'");
  EXPECT_EQ(errors_of_output("{frames: frames/}"),
            "shot.yaml:4:18: error: 'frames' names a file that ends in '.obj' or '.npz', not 'frames/'");
  EXPECT_EQ(errors_of_output("{usd: a.usd}"),
            "shot.yaml:4:15: error: 'usd' names a file that ends in '.usda', not 'a.usd'");
}

TEST(CacheOutputs, EveryMistakeOfAListIsReported) {
  EXPECT_EQ(errors_of_output("{cache: [a.pc2, b.abc, [c.pc2], {pth: d.pc2}]}"),
            "shot.yaml:4:25: error: 'cache' names a file that ends in '.pc2' or '.mdd', not 'b.abc'\n"
            "shot.yaml:4:32: error: 'cache' is a path, not a list\n"
            "shot.yaml:4:42: error: unknown key 'pth' in 'cache'; did you mean 'path'?");
  EXPECT_EQ(errors_of_output("{cache: {}}"), "shot.yaml:4:17: error: 'cache' needs 'path'");
}

TEST(CacheOutputs, OfSequencesNameTheFrameOnce) {
  EXPECT_EQ(errors_of_output("{frames: a.obj}"),
            "shot.yaml:4:18: error: 'a.obj' names the frame's number nowhere; write '%04d' into it, once");
  EXPECT_EQ(
      errors_of_output("{frames: '%d/%04d.obj'}"),
      "shot.yaml:4:18: error: '%d/%04d.obj' names the frame's number more than once; write '%04d' into it, "
      "once");
  for (const char* pattern : {"%4d.obj", "%s.obj", "%.obj", "%00d.obj", "%04d%.npz", "%010d.npz"})
    EXPECT_EQ(errors_of_output("{frames: '" + std::string(pattern) + "'}"),
              "shot.yaml:4:18: error: '" + std::string(pattern) +
                  "' has a '%' that is no '%d' or '%04d', the frame's number, nor '%%', a percent sign");
}

TEST(CacheOutputs, OfASweepNameTheSweptKey) {
  EXPECT_EQ(
      errors_of(with_base("sweep: {lambda: [0, 1]}\noutput: {cache: a.pc2, frames: f_<lambda>/%d.obj}\n")),
      "shot.yaml:5:17: error: output path 'a.pc2' does not name the swept key; write '<lambda>' into it");
  EXPECT_EQ(
      errors_of_output("{usd: a_<lamda>.usda}"),
      "shot.yaml:4:15: error: unknown placeholder '<lamda>' in output path 'a_<lamda>.usda'; did you mean "
      "'<lambda>'?");
}

TEST(CacheOutputs, AreExpandedARun) {
  const std::string text = with_base(
      "sweep: {lambda: [0, 0.5]}\noutput: {cache: <shot>_<lambda>.pc2, frames: <shot>/<lambda>/%04d.obj}\n");
  const std::vector<Shot> runs = parse_shot(text, "50%done.yaml").runs;
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[1].caches.at(0).path, "50%done_0.5.pc2");
  EXPECT_EQ(frame_path(runs[1].caches.at(1).path, 7), "50%done/0.5/0007.obj");
}

TEST(FramePattern, CountsItsNumbers) {
  EXPECT_EQ(count_frame_numbers("a"), 0);
  EXPECT_EQ(count_frame_numbers("a%%d"), 0);
  EXPECT_EQ(count_frame_numbers("%d%%%09d"), 2);
  for (const char* wrong : {"%", "a%", "%0", "%04", "%5d", "%0d", "%x", "%-04d", "%%%"})
    EXPECT_EQ(count_frame_numbers(wrong), std::nullopt) << wrong;
}

TEST(FramePattern, TakesTheNumberWithZerosInFront) {
  EXPECT_EQ(frame_path("f/%04d.obj", 7), "f/0007.obj");
  EXPECT_EQ(frame_path("f/%d.obj", 7), "f/7.obj");
  EXPECT_EQ(frame_path("f/%02d.obj", 12345), "f/12345.obj");
  EXPECT_EQ(frame_path("100%%/%01d", 0), "100%/0");
}

}  // namespace
}  // namespace flexkey
