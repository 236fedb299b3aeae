#pragma once

namespace pybind11 {
class module_;
}

namespace flexkey::python {

/// Each adds its classes and functions to the module, in this order.
void bind_errors(pybind11::module_& module);
void bind_mesh(pybind11::module_& module);
void bind_deformer(pybind11::module_& module);
void bind_clip(pybind11::module_& module);
void bind_timeline(pybind11::module_& module);

}  // namespace flexkey::python
