#include <pybind11/pybind11.h>

#include "cli/options.h"
#include "flexkey/deform/error.h"
#include "flexkey/mesh/error.h"
#include "flexkey/timeline/diagnostic.h"
#include "python/bindings.h"

namespace flexkey::python {

namespace py = pybind11;

void bind_errors(py::module_& module) {
  // Those that are registered later are tried first: from the base to what derives from it.
  const auto error = py::register_exception<Error>(module, "Error", PyExc_RuntimeError);
  error.doc() = "What every exception of flexkey derives from; the message is that of the program.";
  py::register_exception<OutputError>(module, "OutputError", error).doc() =
      "An output file could not be written.";
  const auto input_error = py::register_exception<InputError>(module, "InputError", error);
  input_error.doc() = "A mesh or another input cannot be read or used as it is.";
  py::register_exception<DeformError>(module, "DeformError", input_error).doc() =
      "The rest surface, the constraints or a frame's values cannot be solved.";
  py::register_exception<cli::UsageError>(module, "UsageError", error).doc() = "A call that makes no sense.";
  py::register_exception<TimelineError>(module, "TimelineError", error).doc() =
      "A timeline that cannot be run: a line for every mistake, as file:line:column: error: what.";
}

}  // namespace flexkey::python
