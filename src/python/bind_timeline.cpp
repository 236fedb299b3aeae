#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>

#include "cli/load.h"
#include "flexkey/animate/animate.h"
#include "python/bindings.h"

namespace flexkey::python {

namespace py = pybind11;

namespace {

/// A shot with its mesh, ready to solve.
struct Timeline {
  cli::ShotOptions options;
  std::shared_ptr<const cli::ReadTimeline> read;
  std::shared_ptr<const cli::LoadedShot> loaded;
  Shot shot;  // the file's, or one of its sweep
  Scene scene;
  bool is_swept = false;  // stands for several runs
};

cli::ShotOptions options_of(const std::filesystem::path& path, const py::dict& set) {
  cli::ShotOptions options;
  options.shot = path.string();
  for (const auto& [key, value] : set)
    options.set.push_back(
        fmt::format("{}={}", py::str(key).cast<std::string>(), py::str(value).cast<std::string>()));
  return options;
}

Timeline read_timeline_file(const std::filesystem::path& path, const py::dict& set) {
  const cli::ShotOptions options = options_of(path, set);
  const py::gil_scoped_release others_run;
  const auto read = std::make_shared<const cli::ReadTimeline>(cli::read_shot(options));
  const auto loaded = std::make_shared<const cli::LoadedShot>(cli::load_family(*read, 0, options));
  Scene scene = cli::bind_loaded(loaded->shot, *loaded, options);
  return {options, read, loaded, loaded->shot, std::move(scene), read->runs.size() > 1};
}

std::vector<Timeline> runs(const Timeline& timeline) {
  const auto& [options, read, first, shot, scene, is_swept] = timeline;
  if (!is_swept) return {timeline};
  std::vector<Timeline> result;
  for (std::size_t family = 0; family < read->families.size(); ++family) {
    const auto loaded = std::make_shared<const cli::LoadedShot>(cli::load_family(*read, family, options));
    for (const Shot& run : loaded->runs)
      result.push_back({options, read, loaded, run, cli::bind_loaded(run, *loaded, options)});
  }
  return result;
}

/// All frames; Ctrl-C ends it after a frame.
Clip solve(const Timeline& timeline) {
  if (timeline.is_swept)
    throw cli::UsageError(fmt::format("{}: it has a sweep; solve each of runs()", timeline.shot.file));
  bool is_interrupted = false;
  Clip clip;
  {
    const py::gil_scoped_release others_run;
    AnimateHooks hooks;
    hooks.stop = [&] {
      const py::gil_scoped_acquire back;
      return is_interrupted = PyErr_CheckSignals() != 0;
    };
    clip = animate(timeline.shot, timeline.loaded->mesh, timeline.scene, {}, hooks);
  }
  if (is_interrupted) throw py::error_already_set();
  return clip;
}

std::vector<std::string> handle_names(const Timeline& timeline) {
  std::vector<std::string> names;
  for (const Handle& handle : timeline.shot.handles) names.push_back(handle.name);
  return names;
}

}  // namespace

void bind_timeline(py::module_& module) {
  py::class_<Timeline>(module, "Timeline",
                       "A timeline file and the mesh that it names, every selection resolved.")
      .def(py::init(&read_timeline_file), py::arg("path"), py::arg("set") = py::dict(),
           "set: keys to override, as {'lambda': 0.2, 'handles.tip.weight': 0.5}; values as the file would "
           "have\n"
           "them. Raises TimelineError, a line a mistake, or InputError.")
      .def("solve", &solve, "Solves all frames: a Clip. Raises UsageError for a sweep and DeformError.")
      .def("runs", &runs, py::call_guard<py::gil_scoped_release>(),
           "A Timeline for each value of the sweep, or itself alone.")
      .def_property_readonly("name", [](const Timeline& t) { return t.shot.name; })
      .def_property_readonly(
          "fps", [](const Timeline& t) { return t.shot.fps; }, "Frames a second.")
      .def_property_readonly("frame_count", [](const Timeline& t) { return t.shot.frame_count(); })
      .def_property_readonly(
          "mesh", [](const Timeline& t) { return t.loaded->mesh; }, "At rest.")
      .def_property_readonly("handles", &handle_names, "Their names, in the file's order.")
      .def_property_readonly("warnings", [](const Timeline& t) { return t.loaded->warnings; })
      .def("__repr__", [](const Timeline& t) {
        return fmt::format("<flexkey.Timeline: {}, {} frames of {} vertices>", t.shot.name,
                           t.shot.frame_count(), t.loaded->mesh.vertex_count());
      });
}

}  // namespace flexkey::python
