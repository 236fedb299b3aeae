#include "browser/browser_test.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace flexkey::testing {
namespace {

namespace fs = std::filesystem;

const fs::path viewer = VIEWER_FOLDER;

Outcome run(const std::string& command) {
  Outcome result;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return result;
  for (int byte = std::fgetc(pipe); byte != EOF; byte = std::fgetc(pipe))
    result.output += static_cast<char>(byte);
  result.status = pclose(pipe);
  return result;
}

fs::path chromium() {
  const char* named = std::getenv("CHROMIUM");
  return named != nullptr ? named : "/usr/bin/chromium";
}

}  // namespace

void BrowserTest::SetUp() {
  if (run("node --version 2>&1").status != 0 || !fs::exists(viewer / "node_modules/playwright-core"))
    GTEST_SKIP() << "npm packages are not installed: run `npm ci` in " << viewer << " (needs Node.js)";
  if (!fs::exists(chromium())) GTEST_SKIP() << "Chromium is not installed: " << chromium();
}

Outcome BrowserTest::run_script(const std::string& script, const std::vector<std::string>& arguments) {
  std::string command = fmt::format("node '{}'", (viewer / script).string());
  for (const std::string& argument : arguments) command += fmt::format(" '{}'", argument);
  return run(command + " 2>&1");
}

}  // namespace flexkey::testing
