#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "flexkey/deform/deformer.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/deform_arguments.h"

namespace flexkey::python {

namespace py = pybind11;

namespace {

/// What one frame asks for, read while Python holds still.
struct FrameArguments {
  Targets targets;
  double lambda = 0;
  Eigen::VectorXd field;  // #V, instead of `lambda`; empty: that

  SolveReport solve(const Deformer& deformer, Pose& pose) const {
    return field.size() == 0 ? deformer.solve(targets, lambda, pose) : deformer.solve(targets, field, pose);
  }
};

FrameArguments frame_arguments(const py::handle& targets, const py::handle& lambda, const py::handle& turns) {
  FrameArguments frame{.targets = points_of(targets, "targets"), .field = {}};
  if (!turns.is_none()) frame.targets.turns = points_of(turns, "turns");
  if (py::isinstance<py::float_>(lambda) || py::isinstance<py::int_>(lambda)) {
    frame.lambda = lambda.cast<double>();
  } else {
    frame.field = numbers_of(lambda, "lambda_");
  }
  return frame;
}

Deformer make_deformer(const Mesh& mesh, const py::handle& handles, const py::kwargs& keywords) {
  const DeformArguments arguments = deform_arguments(handles, keywords);
  const py::gil_scoped_release others_run;
  return Deformer(mesh, arguments.constraints, arguments.options);
}

SolveReport solve_frame(const Deformer& deformer, const py::handle& targets, const py::handle& lambda,
                        Pose& pose, const py::handle& turns) {
  const FrameArguments frame = frame_arguments(targets, lambda, turns);
  const py::gil_scoped_release others_run;
  return frame.solve(deformer, pose);
}

Positions solve_once(const Mesh& mesh, const py::handle& handles, const py::handle& targets,
                     const py::handle& lambda, const py::kwargs& keywords) {
  const Deformer deformer = make_deformer(mesh, handles, keywords);
  Pose pose = deformer.rest_pose();
  const SolveReport report = solve_frame(deformer, targets, lambda, pose, py::none());
  if (!report.converged &&
      PyErr_WarnEx(PyExc_RuntimeWarning,
                   fmt::format("did not converge in {} iterations; about {:.2g} % of the diagonal to go",
                               report.solves, 100 * report.estimate)
                       .c_str(),
                   1) != 0)
    throw py::error_already_set();
  return std::move(pose.positions);
}

void bind_report(py::module_& module) {
  py::class_<SolveReport>(module, "SolveReport", "What the solver says of one frame.")
      .def_readonly("solves", &SolveReport::solves, "Global solves spent.")
      .def_readonly("estimate", &SolveReport::estimate,
                    "Of the distance to the converged shape, a share of the diagonal; infinite: unknown.")
      .def_readonly("converged", &SolveReport::converged)
      .def_readonly("slipped", &SolveReport::slipped, "The surface has lost a turn that its handles made.")
      .def("__repr__", [](const SolveReport& report) {
        return fmt::format("<flexkey.SolveReport: {} after {} solves, estimate {:.2g}{}>",
                           report.converged ? "converged" : "not converged", report.solves, report.estimate,
                           report.slipped ? ", slipped" : "");
      });
}

void bind_pose(py::module_& module) {
  py::class_<Pose>(module, "Pose", "One frame's answer and the next frame's warm start.")
      .def_property_readonly(
          "positions", [](const Pose& pose) { return pose.positions; }, "#V x 3, rest-mesh units; a copy.")
      .def_readonly("converged", &Pose::converged)
      .def(
          "copy", [](const Pose& pose) { return Pose(pose); }, "A pose of its own with the same state.");
}

}  // namespace

void bind_deformer(py::module_& module) {
  bind_report(module);
  bind_pose(module);
  const std::string about = fmt::format(
      "handles: vertices whose targets are given, anchors among them; indices or a mask of #V bools. "
      "Vertices that\n"
      "coincide are not welded. Raises DeformError for what cannot be solved.\n\n{}",
      keywords_doc);
  py::class_<Deformer>(
      module, "Deformer",
      "The paper's method: weights, matrix and factorization once for a set of constraints;\n"
      "then one solve a frame.")
      .def(py::init(&make_deformer), py::arg("mesh"), py::arg("handles"), about.c_str())
      .def("rest_pose", &Deformer::rest_pose, "The mesh at rest, to start from.")
      .def("solve", &solve_frame, py::arg("targets"), py::arg("lambda_"), py::arg("pose"),
           py::arg("turns") = py::none(),
           "Moves `pose`, the frame before, to this frame's answer. targets: #handles x 3, in the order of "
           "handles,\n"
           "rest-mesh units. lambda_: a number or #V numbers, 0 (smoothest) .. 1 (most rigid). turns: a row "
           "a handle\n"
           "(see owner), its world rotation vector since the last frame in radians, whole turns counted.\n"
           "Raises DeformError, and leaves the pose as it was, where a value does not fit.");
  module.def("solve", &solve_once, py::arg("mesh"), py::arg("handles"), py::arg("targets"),
             py::arg("lambda_") = 0.5,
             fmt::format("The one-off case: #V x 3 positions of the mesh with its handles at their targets.\n"
                         "Warns (RuntimeWarning) where it did not converge.\n{}",
                         about)
                 .c_str());
}

}  // namespace flexkey::python
