// The page that plays a shot, opened from its file in Chromium.
#include <gtest/gtest.h>

#include <fstream>

#include "browser/browser_test.h"
#include "cli/html_page.h"
#include "cli/load.h"
#include "flexkey/animate/animate.h"
#include "flexkey/html/write_page.h"

namespace flexkey::testing {
namespace {

class Page : public BrowserTest {
 protected:
  /// Writes a page of the clip, with its GLB as `web`.
  void write(const Clip& clip, PageContents contents, GltfOptions options = {}) {
    options.basis = BasisKind::pca;
    options.encoding = Encoding::meshopt;
    contents.glb = make_glb(clip, options).bytes;
    write_page(clip, contents, page());
  }

  /// The page of timelines/nose.yaml.
  void write_nose() {
    cli::ShotOptions options;
    options.shot = FLEXKEY_SOURCE "/timelines/nose.yaml";
    const cli::LoadedShot loaded = cli::load_shot(options);
    const Scene scene = bind_shot(loaded.shot, loaded.mesh);
    const Clip clip = animate(loaded.shot, loaded.mesh, scene);
    write(clip, {.glb = {}, .handles = cli::page_handles({loaded.shot, scene, clip}), .clips = {}});
  }

  void expect_that_it(const std::string& what) {
    const Outcome outcome = run_script("proof/page.mjs", {what, page().string()});
    EXPECT_EQ(outcome.status, 0) << outcome.output;
  }

  std::filesystem::path page() const { return folder_ / "shot.html"; }
};

PageHandle resting(const std::string& name, std::size_t frames) {
  return {name, true, std::vector<Positions>(frames, Positions::Zero(1, 3))};
}

TEST_F(Page, PlaysFromAFileWithoutARequest) {
  write(clip_of(cube(), 24, twist), {});
  expect_that_it("plays");
}

TEST_F(Page, GoesToTheFrameThatIsAskedFor) {
  write(clip_of(cube(), 25, twist), {});
  expect_that_it("scrubs");
}

TEST_F(Page, DrawsTheNoseAtFourTimes) {
  write_nose();
  expect_that_it("draws");
}

TEST_F(Page, FitsLargeAndSmallScreens) {
  Clip clip = clip_of(cube(), 12, twist);
  clip.name = "a_shot_of_which_the_name_is_rather_long_and_has_no_gap_at_all_to_break_it_at";
  GltfOptions options;
  options.clips = {{"one with a long name, too", 0, 0.2}, {"another one", 0.2, 0.4}};
  write(clip, {.glb = {}, .handles = {resting("base", 12)}, .clips = {{"another one", 0.2}}}, options);
  expect_that_it("fits");
}

TEST_F(Page, OffersEveryClip) {
  GltfOptions options;
  options.clips = {{"first", 0, 0.5}, {"second", 0.4, 1}};
  write(clip_of(sheet(3), 25, twist),
        {.glb = {}, .handles = {resting("base", 25)}, .clips = {{"first", 0}, {"second", 0.4}}}, options);
  expect_that_it("choosesClips");
}

TEST_F(Page, NamesWithMarkupAreHarmless) {
  Clip clip = clip_of(cube(), 3, twist);
  clip.name = "</script><script>alert(1)</script><!--";
  write(clip, {.glb = {}, .handles = {resting("<img src=x onerror=alert(2)>]]>", 3)}, .clips = {}});
  expect_that_it("isHarmless");
}

TEST_F(Page, SaysThatWebGLIsMissing) {
  write(clip_of(cube(), 3, twist), {});
  expect_that_it("lacksWebGL");
}

TEST_F(Page, ItsCheckFindsAPageWithoutAMesh) {
  write(clip_of(cube(), 3, stay), {});
  const Outcome outcome = run_script("proof/page.mjs", {"draws", page().string()});
  EXPECT_NE(outcome.status, 0);
  EXPECT_NE(outcome.output.find("show the same"), std::string::npos) << outcome.output;
}

class Viewer : public BrowserTest {};

TEST_F(Viewer, IsWhatItsSourcesBuild) {
  const Outcome outcome = run_script("build.mjs", {"--check"});
  EXPECT_EQ(outcome.status, 0) << outcome.output;
}

}  // namespace
}  // namespace flexkey::testing
