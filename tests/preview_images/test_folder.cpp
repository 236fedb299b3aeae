#include "preview_images/test_folder.h"

#include <algorithm>
#include <cstdlib>

#include "flexkey/mesh/error.h"

namespace flexkey::test {
namespace {

class Modules : public testing::Environment {
  void SetUp() override { setenv("FLEXKEY_MODULES", FLEXKEY_MODULE_FOLDER, 1); }
};
const testing::Environment* const modules = testing::AddGlobalTestEnvironment(new Modules);

}  // namespace

void TestFolder::SetUp() {
  std::filesystem::remove_all(folder_);
  std::filesystem::create_directories(folder_);
}

std::vector<std::string> TestFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

Picture ramps(int width, int height) {
  Picture picture{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      picture.rgb.insert(picture.rgb.end(),
                         {(static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                          (static_cast<float>(y) + 0.5f) / static_cast<float>(height), 0.5f});
  return picture;
}

}  // namespace flexkey::test
