#include "python/deform_arguments.h"

#include <fmt/format.h>
#include <pybind11/numpy.h>

#include <functional>
#include <map>

#include "flexkey/mesh/spelling.h"
#include "python/arrays.h"

namespace flexkey::python {

namespace py = pybind11;

namespace {

using Read = std::function<void(const py::handle& value, const std::string& name)>;

template <class Enum>
Read choice(Enum& target, std::map<std::string, Enum> words) {
  return [&target, words = std::move(words)](const py::handle& value, const std::string& name) {
    const auto word = py::str(value).cast<std::string>();
    if (const auto found = words.find(word); found != words.end()) {
      target = found->second;
      return;
    }
    std::vector<std::string> known;
    for (const auto& [text, ignored] : words) known.push_back(text);
    throw py::value_error(fmt::format("{}: '{}' is none of {}", name, word, fmt::join(known, ", ")));
  };
}

template <class Value>
Read plain(Value& target, const char* wanted) {
  return [&target, wanted](const py::handle& value, const std::string& name) {
    try {
      target = value.cast<Value>();
    } catch (const py::cast_error&) {
      throw py::value_error(
          fmt::format("{}: expected {}, got {}", name, wanted, py::repr(value).cast<std::string>()));
    }
  };
}

Read indices(std::vector<int>& target) {
  return [&](const py::handle& value, const std::string& name) { target = indices_of(value, name); };
}

std::map<std::string, Read> readers_of(DeformArguments& to) {
  Constraints& c = to.constraints;
  DeformOptions& o = to.options;
  return {
      {"region", indices(c.region)},
      {"owner", indices(c.owner)},
      {"strengths",
       [&](const py::handle& value, const std::string& name) {
         const Eigen::VectorXd numbers = numbers_of(value, name);
         c.strengths.assign(numbers.begin(), numbers.end());
       }},
      {"rigid",
       [&](const py::handle& value, const std::string& name) {
         for (const py::handle part : value) c.rigid.push_back(indices_of(part, name));
       }},
      {"system",
       choice<System>(o.system, {{"least-squares", System::least_squares}, {"direct", System::direct}})},
      {"local_scale", choice<LocalScale>(o.local_scale, {{"axis", LocalScale::axis},
                                                         {"uniform", LocalScale::uniform},
                                                         {"none", LocalScale::none}})},
      {"epsilon", plain(o.epsilon, "a number")},
      {"weights", choice<Weights>(o.weights, {{"clamped", Weights::clamped},
                                              {"cotangent", Weights::cotangent},
                                              {"intrinsic-delaunay", Weights::intrinsic_delaunay},
                                              {"uniform", Weights::uniform}})},
      {"cell", choice<Cell>(o.cell, {{"spokes", Cell::spokes}, {"spokes-and-rims", Cell::spokes_and_rims}})},
      {"area_weighting", plain(o.area_weighting, "True or False")},
      {"iterations", plain(o.iterations, "a whole number")},
      {"tolerance", plain(o.tolerance, "a number")},
      {"predict", plain(o.predict, "True or False")},
      {"accelerate", plain(o.accelerate, "True or False")},
  };
}

}  // namespace

DeformArguments deform_arguments(const py::handle& handles, const py::kwargs& keywords) {
  DeformArguments result;
  result.constraints.handles = indices_of(handles, "handles");
  const std::map<std::string, Read> readers = readers_of(result);
  for (const auto& [key, value] : keywords) {
    const auto name = key.cast<std::string>();
    const auto reader = readers.find(name);
    if (reader == readers.end()) {
      std::vector<std::string> known;
      for (const auto& [text, ignored] : readers) known.push_back(text);
      throw py::type_error(fmt::format("unknown keyword '{}'{}", name, did_you_mean(name, known)));
    }
    reader->second(value, name);
  }
  return result;
}

}  // namespace flexkey::python
