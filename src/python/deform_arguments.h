#pragma once

#include "flexkey/deform/deformer.h"
#include "flexkey/deform/options.h"

namespace pybind11 {
class kwargs;
class handle;
}  // namespace pybind11

namespace flexkey::python {

/// What is constrained, and how it is solved.
struct DeformArguments {
  Constraints constraints;
  DeformOptions options;
};

/// Of the handles' vertices and the keyword arguments of `Deformer` and `solve`. Raises TypeError for an
/// unknown name and ValueError for a value that does not fit.
DeformArguments deform_arguments(const pybind11::handle& handles, const pybind11::kwargs& keywords);

/// What the docstrings say of these keyword arguments.
inline constexpr const char* keywords_doc =
    "Keywords: region (vertices that may move; default all), owner (#handles, which handle leads each "
    "vertex, from\n"
    "0), strengths (a number a handle in (0, 1]; below 1 it is soft and goes about that share of the way), "
    "rigid (a\n"
    "list of vertex lists; each moves as one body); and the timeline's solver keys: system "
    "('least-squares',\n"
    "'direct'), local_scale ('axis', 'uniform', 'none'), epsilon, weights ('clamped', 'cotangent',\n"
    "'intrinsic-delaunay', 'uniform'), cell ('spokes', 'spokes-and-rims'), area_weighting, iterations, "
    "tolerance (a\n"
    "share of the bounding box's diagonal), predict, accelerate.";

}  // namespace flexkey::python
