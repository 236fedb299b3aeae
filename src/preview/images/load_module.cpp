#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <string_view>
#include <system_error>

#include "flexkey/mesh/error.h"
#include "flexkey/preview/images/module.h"

namespace flexkey {
namespace {

namespace fs = std::filesystem;

constexpr const char* file_name = "flexkey_images.so";
constexpr const char* factory_name = "flexkey_image_module";

std::vector<fs::path> module_folders() {
  if (const char* chosen = std::getenv("FLEXKEY_MODULES")) return {chosen};
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  return {program, (program / FLEXKEY_MODULE_FROM_PROGRAM).lexically_normal()};
}

fs::path find_module() {
  std::string searched;
  for (const fs::path& folder : module_folders()) {
    std::error_code unknown;
    if (fs::exists(folder / file_name, unknown)) return folder / file_name;
    searched += fmt::format("{}'{}'", searched.empty() ? "" : " or ", folder.string());
  }
  throw OutputError(
      fmt::format("cannot make pictures: no {} in {}; to have it, install the package libopenimageio-dev "
                  "and build flexkey again",
                  file_name, searched));
}

const ImageModule& load_module() {
  const fs::path path = find_module();
  void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);  // never closed: OpenImageIO keeps threads
  if (!module)
    throw OutputError(
        fmt::format("cannot make pictures: {}; install the package libopenimageio2.4", dlerror()));
  using Factory = const ImageModule*();
  Factory* const factory = reinterpret_cast<Factory*>(dlsym(module, factory_name));
  if (!factory || std::string_view(factory()->version) != FLEXKEY_VERSION)
    throw OutputError(
        fmt::format("cannot make pictures: '{}' is not of flexkey {}", path.string(), FLEXKEY_VERSION));
  return *factory();
}

}  // namespace

const ImageModule& image_module() {
  static const ImageModule& module = load_module();
  return module;
}

}  // namespace flexkey
