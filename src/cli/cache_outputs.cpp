#include "cli/cache_outputs.h"

#include <fmt/format.h>

#include <numeric>
#include <set>

#include "cli/output_paths.h"
#include "cli/stopwatch.h"
#include "flexkey/cache/mdd.h"
#include "flexkey/cache/npz_sequence.h"
#include "flexkey/cache/obj_sequence.h"
#include "flexkey/cache/pc2.h"
#include "flexkey/cache/usda.h"
#include "flexkey/mesh/output_file.h"
#include "flexkey/timeline/frame_pattern.h"

namespace flexkey::cli {
namespace {

namespace fs = std::filesystem;
using Form = CacheOutput::Form;

std::vector<int> frames_of(const LoadedShot& loaded, const ShotOptions& options) {
  std::vector<int> frames = parse_frames(options.frames, loaded.shot.frame_count());
  if (!frames.empty()) return frames;
  frames.resize(static_cast<std::size_t>(loaded.shot.frame_count()));
  std::iota(frames.begin(), frames.end(), 0);
  return frames;
}

/// The file of a frame, which may be that of all.
fs::path path_of(const CacheOutput& cache, int frame, const fs::path& out_dir) {
  return out_dir / (cache.is_sequence() ? frame_path(cache.path, frame) : cache.path);
}

/// The frames that have a file of their own, or one that stands for all.
std::vector<int> files_of(const CacheOutput& cache, const std::vector<int>& frames) {
  return cache.is_sequence() ? frames : std::vector<int>{frames.front()};
}

/// What is wrong with a cache, or nothing. taken: the files of the outputs before it; its own are added.
std::string fault_of(const CacheOutput& cache, const LoadedShot& loaded, const ShotOptions& options,
                     std::set<fs::path>& taken) {
  const std::vector<int> frames = frames_of(loaded, options);
  if (cache.form == Form::pc2 && even_step(frames) == 0)
    return fmt::format(
        "the frames of '{}' must be evenly spaced in a PC2, and --frames {} are not; an .mdd takes "
        "them as they are",
        cache.path, options.frames);
  for (const int frame : files_of(cache, frames)) {
    const fs::path path = path_of(cache, frame, options.out_dir);
    if (is_special(path)) continue;
    if (replaces_input(loaded, path))
      return fmt::format("the output '{}' would replace an input; give it another name", path.string());
    if (!taken.insert(fs::absolute(path).lexically_normal()).second)
      return fmt::format("the output '{}' is named twice; each needs a name of its own", path.string());
  }
  return {};
}

/// The mesh's material libraries, which are among the inputs.
std::vector<fs::path> material_libraries(const LoadedShot& loaded) {
  std::vector<fs::path> libraries;
  for (const fs::path& input : loaded.inputs)
    if (input.extension() == ".mtl") libraries.push_back(input);
  return libraries;
}

FrameSink sink_of(const CacheOutput& cache, const CacheShape& shape, const LoadedShot& loaded,
                  const fs::path& out_dir) {
  const fs::path path = out_dir / cache.path;
  const FramePath numbered = [cache, out_dir](int frame) { return path_of(cache, frame, out_dir); };
  switch (cache.form) {
    case Form::pc2:
      return pc2_sink(path, shape);
    case Form::mdd:
      return mdd_sink(path, shape);
    case Form::obj:
      return obj_sequence_sink(numbered, shape, material_libraries(loaded));
    case Form::npz:
      return npz_sequence_sink(numbered, shape);
    case Form::usda:
      break;
  }
  return usda_sink(path, shape);
}

std::string_view name_of(Form form) {
  switch (form) {
    case Form::pc2:
      return "pc2";
    case Form::mdd:
      return "mdd";
    case Form::obj:
      return "obj";
    case Form::npz:
      return "npz";
    case Form::usda:
      break;
  }
  return "usda";
}

CacheShape shape_of(const LoadedShot& loaded, const ShotOptions& options) {
  CacheShape shape{loaded.shot.name, loaded.mesh, loaded.shot.fps, frames_of(loaded, options), {}};
  if (loaded.shot.mesh.up == UpAxis::z) shape.up = CacheShape::Up::z;
  for (const Handle& handle : loaded.shot.handles) shape.handles.push_back(handle.name);
  return shape;
}

}  // namespace

void check_caches(const LoadedShot& loaded, const ShotOptions& options, const std::vector<Shot>& runs) {
  std::set<fs::path> taken;
  for (const Shot& run : runs)
    for (const CacheOutput& cache : run.caches)
      if (const std::string fault = fault_of(cache, loaded, options, taken); !fault.empty())
        throw TimelineError(loaded.shot.file, {error_at(cache.where, fault, options.overrides())});
}

void probe_caches(const LoadedShot& loaded, const ShotOptions& options, const std::vector<Shot>& runs) {
  const int first = frames_of(loaded, options).front();
  for (const Shot& run : runs)
    for (const CacheOutput& cache : run.caches)
      // What reads a pipe would take the probe for the whole.
      if (const fs::path path = path_of(cache, first, options.out_dir); !is_special(path))
        OutputFile probe(path);
}

RunCaches::RunCaches(const LoadedShot& loaded, const ShotOptions& options, const Shot& run) {
  const CacheShape shape = shape_of(loaded, options);
  for (const CacheOutput& cache : run.caches) {
    FrameSink sink = sink_of(cache, shape, loaded, options.out_dir);
    WrittenCache report{options.out_dir / cache.path, name_of(cache.form)};
    caches_.push_back({std::move(report), cache.is_sequence(), std::move(sink)});
  }
}

void RunCaches::add(const SolvedFrame& frame) {
  for (Open& cache : caches_) {
    const Stopwatch watch;
    cache.sink.add(frame);
    cache.report.files = cache.is_sequence ? cache.report.files + 1 : 1;
    cache.report.seconds += watch.seconds();
  }
}

std::vector<WrittenCache> RunCaches::finish() {
  std::vector<WrittenCache> written;
  for (Open& cache : caches_) {
    const Stopwatch watch;
    cache.report.bytes = cache.sink.finish();
    cache.report.seconds += watch.seconds();
    written.push_back(cache.report);
  }
  return written;
}

double RunCaches::seconds() const {
  return std::accumulate(caches_.begin(), caches_.end(), 0.0,
                         [](double sum, const Open& cache) { return sum + cache.report.seconds; });
}

std::vector<std::string> RunCaches::fates() const {
  std::vector<std::string> fates;
  for (const Open& cache : caches_)
    fates.push_back(cache.is_sequence
                        ? fmt::format("'{}' has {} frames", cache.report.path.string(), cache.report.files)
                        : fmt::format("'{}' was not written", cache.report.path.string()));
  return fates;
}

}  // namespace flexkey::cli
