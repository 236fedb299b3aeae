#include "flexkey/html/base64.h"

#include <gtest/gtest.h>

namespace flexkey {
namespace {

TEST(Base64, IsThatOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, TakesBytesOfEveryValue) {
  EXPECT_EQ(base64(std::string_view("\0\xFF\x10\x83\xFB\xFF", 6)), "AP8Qg/v/");
}

}  // namespace
}  // namespace flexkey
