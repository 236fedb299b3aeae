#include "flexkey/gltf/utf8.h"

#include <gtest/gtest.h>

namespace flexkey {
namespace {

TEST(Utf8, LeavesValidTextAlone) {
  for (const std::string text : {"", "nose", "Füße", "顔", "🐖", "\U0010FFFF", "\uFFFD"}) {
    EXPECT_EQ(valid_utf8(text), text);
  }
}

TEST(Utf8, ReplacesEachByteThatIsNot) {
  EXPECT_EQ(valid_utf8("Fu\xDF"
                       "e"),
            "Fu\uFFFDe");                                       // Latin-1
  EXPECT_EQ(valid_utf8("\xC3"), "\uFFFD");                      // ends too early
  EXPECT_EQ(valid_utf8("\x80x"), "\uFFFDx");                    // continues nothing
  EXPECT_EQ(valid_utf8("\xC0\xAF"), "\uFFFD\uFFFD");            // overlong
  EXPECT_EQ(valid_utf8("\xE0\x80\xAF"), "\uFFFD\uFFFD\uFFFD");  // overlong
  EXPECT_EQ(valid_utf8("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");  // surrogate
  EXPECT_EQ(valid_utf8("\xF4\x90\x80\x80").size(), 12u);        // beyond U+10FFFF
  EXPECT_EQ(valid_utf8("\xFF"), "\uFFFD");
}

}  // namespace
}  // namespace flexkey
