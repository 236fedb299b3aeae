#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "flexkey/preview/picture.h"

namespace flexkey::test {

/// A test with an empty folder of its own, and flexkey's module at hand.
class TestFolder : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override { std::filesystem::remove_all(folder_); }

  const std::filesystem::path& folder() const { return folder_; }
  /// The names of what lies in the folder, sorted.
  std::vector<std::string> names() const;

 private:
  const testing::TestInfo* info_ = testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) /
                                        (std::string("flexkey_") + info_->test_suite_name() + info_->name());
};

/// What flexkey says of a failing action, or "nothing was thrown".
std::string message_of(const std::function<void()>& action);

/// Red grows to the right, green downwards, blue is even: 0..1 in linear light.
Picture ramps(int width, int height);

}  // namespace flexkey::test
