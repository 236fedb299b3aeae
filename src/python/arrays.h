#pragma once

#include <string_view>
#include <vector>

#include "flexkey/mesh/types.h"

namespace pybind11 {
class array;
class handle;
}  // namespace pybind11

namespace flexkey::python {

/// What NumPy makes an array of, as n x 3 numbers. name: the argument's, for the ValueError that is raised
/// where it does not fit.
Positions points_of(const pybind11::handle& value, std::string_view name);

/// As n numbers.
Eigen::VectorXd numbers_of(const pybind11::handle& value, std::string_view name);

/// As n indices; a mask of bools gives the places where it is true.
std::vector<int> indices_of(const pybind11::handle& value, std::string_view name);

/// A read-only view of numbers that `owner` keeps alive.
pybind11::array view_of(const Positions& positions, const pybind11::handle& owner);

/// A copy.
pybind11::array array_of(const std::vector<int>& values);

}  // namespace flexkey::python
