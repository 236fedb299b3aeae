#include <fmt/format.h>

#include <map>
#include <set>

#include "cli/output_paths.h"
#include "cli/preview_settings.h"
#include "cli/previews.h"
#include "flexkey/mesh/output_file.h"
#include "flexkey/timeline/parse.h"

namespace flexkey::cli {
namespace {

namespace fs = std::filesystem;

/// A file that pictures are written to.
struct PictureFile {
  fs::path path;
  Mark where;
};

/// But for a sheet, which runs may share.
std::vector<PictureFile> files_of(const Shot& run, const ShotOptions& options) {
  const PreviewOutput& preview = run.preview;
  std::vector<PictureFile> files;
  const PictureSequence sequence = sequence_of(preview, options);
  for (const int frame : drawn_frames(run, options))
    files.push_back({frame_path(sequence, frame), preview.where});
  if (!preview.gif.path.empty()) files.push_back({options.out_dir / preview.gif.path, preview.gif.where});
  return files;
}

/// What is wrong with a file, or nothing. taken: the files before it; it is added.
std::string fault_of(const PictureFile& file, const LoadedShot& loaded, std::set<fs::path>& taken) {
  if (replaces_input(loaded, file.path))
    return fmt::format("the output '{}' would replace an input; give it another name", file.path.string());
  if (!taken.insert(fs::absolute(file.path).lexically_normal()).second)
    return fmt::format("the output '{}' is named twice; each needs a name of its own", file.path.string());
  return {};
}

}  // namespace

void check_previews(const LoadedShot& loaded, const ShotOptions& options, const std::vector<Shot>& runs) {
  if (loaded.shot.preview.dir.empty()) return;
  std::vector<PictureFile> files;
  std::map<std::string, Mark> sheets;
  for (const Shot& run : runs) {
    for (PictureFile& file : files_of(run, options)) files.push_back(std::move(file));
    if (!run.preview.sheet.path.empty()) sheets.emplace(run.preview.sheet.path, run.preview.sheet.where);
  }
  for (const auto& [path, where] : sheets) files.push_back({options.out_dir / path, where});
  std::set<fs::path> taken;
  for (const PictureFile& file : files)
    if (const std::string fault = fault_of(file, loaded, taken); !fault.empty())
      throw TimelineError(loaded.shot.file, {error_at(file.where, fault, options.overrides())});
}

void probe_previews(const ShotOptions& options, const std::vector<Shot>& runs) {
  const auto probe = [](const fs::path& path) {
    if (!is_special(path)) OutputFile unwritten(path);  // made and, uncommitted, removed again
  };
  for (const Shot& run : runs) {
    const PreviewOutput& preview = run.preview;
    if (preview.dir.empty()) continue;
    if (const std::vector<int> drawn = drawn_frames(run, options); !drawn.empty())
      probe(frame_path(sequence_of(preview, options), drawn.front()));
    for (const std::string& path : {preview.gif.path, preview.sheet.path})
      if (!path.empty()) probe(options.out_dir / path);
  }
}

}  // namespace flexkey::cli
