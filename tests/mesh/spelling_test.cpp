#include "flexkey/mesh/spelling.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace flexkey {
namespace {

const std::vector<std::string> keys{"rotate", "move", "scale", "select", "leg_hind_left", "leg_hind_right"};

TEST(Spelling, FindsTheKeyThatWasMeant) {
  EXPECT_EQ(nearest_word("rotat", keys), "rotate");
  EXPECT_EQ(nearest_word("rotaet", keys), "rotate");
  EXPECT_EQ(nearest_word("Scale", keys), "scale");
  EXPECT_EQ(nearest_word("leg_hind_l", keys), "leg_hind_left");
}

TEST(Spelling, ProposesNothingForAWordFarFromAll) {
  EXPECT_EQ(nearest_word("texture", keys), "");
  EXPECT_EQ(nearest_word("", keys), "");
  EXPECT_EQ(nearest_word(std::string(100000, 'r'), keys), "");
}

TEST(Spelling, HintIsTheTailOfASentence) {
  EXPECT_EQ(did_you_mean("rotat", keys), "; did you mean 'rotate'?");
  EXPECT_EQ(did_you_mean("zzz", keys), "");
}

}  // namespace
}  // namespace flexkey
