#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cli/run_program.h"
#include "support/meshes.h"

namespace flexkey::test {

inline constexpr const char* minimal_shot =
    "mesh: bar.obj\n"
    "handles:\n"
    "  base: {select: {axis: z, below: 1%}}\n"
    "  tip:\n"
    "    select: {axis: z, above: 99%}\n"
    "    rotate: {axis: z, keys: {0s: 0deg, 1s: 90deg}}\n"
    "output: bar.glb\n";

/// Positions and faces as an OBJ text.
inline std::string obj_text(const Mesh& mesh) {
  std::string text;
  for (const auto& p : mesh.positions.rowwise()) text += fmt::format("v {} {} {}\n", p[0], p[1], p[2]);
  for (int f = 0; f < mesh.face_count(); ++f) {
    text += "f";
    for (const int v : mesh.face(f)) text += fmt::format(" {}", v + 1);
    text += "\n";
  }
  return text;
}

/// A test with an empty folder of its own in which the program runs; bar.obj lies there.
class WorkFolder : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    write("bar.obj", obj_text(meshes::bar(3, 3, 12)));
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  const std::filesystem::path& folder() const { return folder_; }
  /// The names in a folder, in order.
  std::vector<std::string> names_in(const std::string& name) const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / name))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  ProgramResult run(const std::vector<std::string>& arguments, const std::string& input = {},
                    const std::string& wrapper = {}, const std::string& redirect = {}) const {
    return run_program(folder_, arguments, {input, wrapper, redirect});
  }

 private:
  const testing::TestInfo* info_ = testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string("flexkey_") + info_->test_suite_name() + "_" + info_->name());
};

}  // namespace flexkey::test
