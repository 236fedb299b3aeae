#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "gltf/clips.h"

namespace flexkey::testing {

struct Outcome {
  int status = -1;
  std::string output;  // of both streams
};

/// A test that runs scripts of tools/viewer in a folder of its own; skipped where Chromium or the npm
/// packages are missing.
class BrowserTest : public ::testing::Test {
 protected:
  void SetUp() override;

  /// script: as tools/viewer has it, "proof/play.mjs".
  static Outcome run_script(const std::string& script, const std::vector<std::string>& arguments);

  TemporaryFolder folder_;
};

}  // namespace flexkey::testing
