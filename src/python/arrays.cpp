#include "python/arrays.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/numpy.h>

#include <limits>

namespace flexkey::python {

namespace py = pybind11;

namespace {

/// "(4, 2)".
std::string shape_text(const py::array& array) {
  return py::str(array.attr("shape")).cast<std::string>();
}

[[noreturn]] void refuse(std::string_view name, std::string_view wanted, std::string_view got) {
  throw py::value_error(fmt::format("{}: expected {}, got {}", name, wanted, got));
}

/// As an array of doubles or of 64-bit integers, whatever it is of.
template <class Number>
py::array_t<Number> array_like(const py::handle& value, std::string_view name, std::string_view wanted) {
  auto array = py::array_t<Number, py::array::c_style | py::array::forcecast>::ensure(value);
  if (!array) {
    PyErr_Clear();
    refuse(name, wanted, py::str(py::type::of(value)).cast<std::string>());
  }
  return array;
}

}  // namespace

Positions points_of(const py::handle& value, std::string_view name) {
  constexpr const char* wanted = "an array of n x 3 numbers";
  const py::array_t<double> array = array_like<double>(value, name, wanted);
  if (array.ndim() != 2 || array.shape(1) != 3)
    refuse(name, wanted, fmt::format("the shape {}", shape_text(array)));
  return Eigen::Map<const Positions>(array.data(), array.shape(0), 3);
}

Eigen::VectorXd numbers_of(const py::handle& value, std::string_view name) {
  constexpr const char* wanted = "an array of n numbers";
  const py::array_t<double> array = array_like<double>(value, name, wanted);
  if (array.ndim() != 1) refuse(name, wanted, fmt::format("the shape {}", shape_text(array)));
  return Eigen::Map<const Eigen::VectorXd>(array.data(), array.shape(0));
}

std::vector<int> indices_of(const py::handle& value, std::string_view name) {
  constexpr const char* wanted = "an array of n indices, or a mask";
  py::array given = py::array::ensure(value);
  if (!given) {
    PyErr_Clear();
    refuse(name, wanted, py::str(py::type::of(value)).cast<std::string>());
  }
  if (given.ndim() != 1) refuse(name, wanted, fmt::format("the shape {}", shape_text(given)));
  if (given.size() == 0) return {};
  if (given.dtype().kind() == 'b') given = py::array(given.attr("nonzero")().cast<py::tuple>()[0]);
  if (given.dtype().kind() != 'i' && given.dtype().kind() != 'u')
    refuse(name, wanted, fmt::format("numbers of type {}", py::str(given.dtype()).cast<std::string>()));
  const py::array_t<std::int64_t> array = array_like<std::int64_t>(given, name, wanted);
  std::vector<int> indices;
  for (py::ssize_t k = 0; k < array.size(); ++k) {
    const std::int64_t index = array.at(k);
    if (index < 0 || index > std::numeric_limits<int>::max())
      refuse(name, "indices from 0", fmt::format("{}", index));
    indices.push_back(static_cast<int>(index));
  }
  return indices;
}

py::array view_of(const Positions& positions, const py::handle& owner) {
  py::array_t<double> view({positions.rows(), Eigen::Index{3}}, positions.data(), owner);
  view.attr("flags").attr("writeable") = false;
  return view;
}

py::array array_of(const std::vector<int>& values) {
  return py::array_t<int>(static_cast<py::ssize_t>(values.size()), values.data());
}

}  // namespace flexkey::python
