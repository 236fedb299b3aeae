#include <pybind11/pybind11.h>

#include "python/bindings.h"

PYBIND11_MODULE(flexkey, module) {
  module.doc() =
      "Animate a mesh without a rig: as-flexible-as-wanted surface deformation.\n\n"
      "Arrays are NumPy's: positions #V x 3 in the mesh's units, indices from 0, angles in radians. λ is "
      "called\n"
      "`lambda_`: 0 is smoothest, 1 most rigid. Other threads of Python run while flexkey solves.";
  module.attr("__version__") = FLEXKEY_VERSION;
  flexkey::python::bind_errors(module);
  flexkey::python::bind_mesh(module);
  flexkey::python::bind_deformer(module);
  flexkey::python::bind_clip(module);
  flexkey::python::bind_timeline(module);
}
