#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "flexkey/animate/clip.h"
#include "flexkey/gltf/write_glb.h"
#include "python/arrays.h"
#include "python/bindings.h"

namespace flexkey::python {

namespace py = pybind11;

namespace {

py::list frames_of(const py::object& owner) {
  py::list frames;
  for (const Positions& frame : owner.cast<const Clip&>().frames) frames.append(view_of(frame, owner));
  return frames;
}

void write(const Clip& clip, const std::filesystem::path& path) {
  write_glb(clip, {}, path);
}

}  // namespace

void bind_clip(py::module_& module) {
  py::class_<FrameReport>(module, "FrameReport", "What the solver says of one frame.")
      .def_readonly("frame", &FrameReport::frame, "From 0; its time is frame / fps.")
      .def_readonly("lambda_", &FrameReport::lambda)
      .def_readonly("solves", &FrameReport::solves, "Global solves spent.")
      .def_readonly("estimate", &FrameReport::estimate,
                    "Of the distance to the converged shape, a share of the diagonal; infinite: unknown.")
      .def_readonly("converged", &FrameReport::converged)
      .def_readonly("slipped", &FrameReport::slipped, "The surface has lost a turn that its handles made.");
  py::class_<Clip>(module, "Clip", "A solved animation.")
      .def_readonly("name", &Clip::name)
      .def_readonly("mesh", &Clip::mesh, "At rest.")
      .def_readonly("fps", &Clip::fps, "Frames a second.")
      .def_property_readonly("frames", &frames_of,
                             "#frames arrays of #V x 3, read-only, in the mesh file's order and units;\n"
                             "numpy.stack makes them one.")
      .def_readonly("reports", &Clip::reports, "#frames FrameReports.")
      .def("write_glb", &write, py::arg("path"), py::call_guard<py::gil_scoped_release>(),
           "Writes a GLB of the profile `compat`. Raises OutputError.")
      .def("__repr__", [](const Clip& clip) {
        return fmt::format("<flexkey.Clip: {}, {} frames of {} vertices>", clip.name, clip.frames.size(),
                           clip.mesh.vertex_count());
      });
}

}  // namespace flexkey::python
