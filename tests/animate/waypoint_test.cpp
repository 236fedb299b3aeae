#include "flexkey/animate/waypoint.h"

#include <gtest/gtest.h>

#include <string>

#include "animate/shots.h"
#include "flexkey/animate/animate.h"
#include "flexkey/animate/deform_options.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

using test::held_bar;
using test::shot_of;

/// Half way through a shot in which a handle fades.
class Waypoints : public testing::Test {
 protected:
  Waypoints() : cache_(scene_, deform_options(shot_.solver)) {
    int solved = 0;
    AnimateHooks hooks;
    hooks.on_solved = [&](std::size_t, const SolvedStep&) { ++solved; };
    hooks.stop = [&] { return solved == 5; };
    hooks.on_end = [&](std::size_t, const Waypoint& waypoint) {
      Saving saving([&](std::span<const std::byte> more) {
        saved_.append(reinterpret_cast<const char*>(more.data()), more.size());
      });
      save(waypoint, saving);
    };
    animate(shot_, bar_, scene_, {}, hooks);
  }
  Waypoint loaded(const std::string& bytes) {
    return load_waypoint(std::as_bytes(std::span(bytes)), scene_, cache_);
  }

  const Mesh bar_ = meshes::bar(1, 1, 4);
  const Shot shot_ =
      shot_of(held_bar +
              "  tip: {select: {axis: z, above: 100%}, active: [0s, 2s], fade: 1s, move: {keys: "
              "{0s: [0, 0, 0], 1s: [0, 1, 0]}}}\nfps: 8\n");
  const Scene scene_ = bind_shot(shot_, bar_);
  DeformerCache cache_;
  std::string saved_;
};

TEST_F(Waypoints, KnowTheNextFrameAndThePassageAside) {
  const Waypoint waypoint = loaded(saved_);
  EXPECT_EQ(waypoint.next, 5);
  ASSERT_TRUE(waypoint.without_fading.has_value());
  EXPECT_EQ(waypoint.passage.active, (ActiveSet{0, 1}));
  EXPECT_EQ(waypoint.without_fading->active, (ActiveSet{0}));
}

TEST_F(Waypoints, OfOtherBytesAreRefusedOrFitTheScene) {
  int refused = 0;
  for (std::size_t place = 0; place < saved_.size(); ++place) {
    std::string changed = saved_;
    changed[place] = static_cast<char>(changed[place] ^ 1);
    try {
      const Waypoint waypoint = loaded(changed);
      EXPECT_TRUE(waypoint.passage.deformer->could_have_solved(waypoint.passage.pose));
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 50);
  EXPECT_THROW(loaded(saved_.substr(0, saved_.size() - 1)), ArchiveError);
  EXPECT_THROW(loaded(saved_ + "x"), ArchiveError);
}

TEST_F(Waypoints, OfAnotherSceneAreRefused) {
  const Mesh longer = meshes::bar(1, 1, 5);
  const Scene scene = bind_shot(shot_, longer);
  DeformerCache cache(scene, {});
  EXPECT_THROW(load_waypoint(std::as_bytes(std::span(saved_)), scene, cache), ArchiveError);
}

}  // namespace
}  // namespace flexkey
