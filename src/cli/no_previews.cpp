// What the program knows of pictures where it is built without the libraries that draw them.
#include "cli/previews.h"
#include "cli/shot_picture.h"
#include "flexkey/timeline/parse.h"

namespace flexkey::cli {

struct Previews::Impl {};

namespace {

constexpr const char* fault =
    "this flexkey is built without previews; for them install the packages that 'tools/packages build' names "
    "and build it again";

}  // namespace

bool draws_previews() {
  return false;
}

void preload_previews() {}

void check_previews(const LoadedShot& loaded, const ShotOptions& options, const std::vector<Shot>&) {
  if (loaded.shot.preview.dir.empty()) return;
  throw TimelineError(loaded.shot.file, {error_at(loaded.shot.preview.where, fault, options.overrides())});
}

void check_shot_picture(const LoadedShot&, const std::filesystem::path&) {
  throw UsageError(fault);
}

void write_shot_picture(const LoadedShot&, const Scene&, const std::filesystem::path&) {}

void probe_previews(const ShotOptions&, const std::vector<Shot>&) {}

Previews::Previews(const Session&, const RunStates&) {}
Previews::~Previews() = default;

void Previews::add(std::size_t, const SolvedFrame&) {}

std::vector<WrittenPreview> Previews::finish() {
  return {};
}

std::vector<std::string> Previews::warnings() const {
  return {};
}

std::vector<std::string> Previews::fates() const {
  return {};
}

}  // namespace flexkey::cli
