#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl/filesystem.h>

#include "cli/mesh_input.h"
#include "flexkey/mesh/mesh.h"
#include "python/arrays.h"
#include "python/bindings.h"

namespace flexkey::python {

namespace py = pybind11;

namespace {

Mesh make_mesh(const py::handle& positions, const py::iterable& faces) {
  Mesh mesh;
  mesh.positions = points_of(positions, "positions");
  mesh.face_offsets.push_back(0);
  for (const py::handle face : faces) {
    const std::string name = fmt::format("face {}", mesh.face_count());
    const std::vector<int> corners = indices_of(face, name);
    if (corners.size() < 3) throw py::value_error(fmt::format("{}: it has {} corners", name, corners.size()));
    for (const int corner : corners)
      if (corner >= mesh.vertex_count())
        throw py::value_error(
            fmt::format("{}: there is no vertex {} among {}", name, corner, mesh.vertex_count()));
    mesh.add_face(corners);
  }
  return mesh;
}

py::list faces_of(const Mesh& mesh) {
  py::list faces;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> corners = mesh.face(f);
    faces.append(array_of({corners.begin(), corners.end()}));
  }
  return faces;
}

py::dict groups_of(const Mesh& mesh) {
  py::dict groups;
  for (const Group& group : mesh.groups) groups[py::str(group.name)] = array_of(group.faces);
  return groups;
}

}  // namespace

void bind_mesh(py::module_& module) {
  py::class_<Mesh>(module, "Mesh", "A polygon mesh: polygons stay polygons and vertices keep their order.")
      .def(py::init(&make_mesh), py::arg("positions"), py::arg("faces"),
           "positions: #V x 3, in any unit. faces: #F x 3, #F x 4, or a list of lists: vertex indices from "
           "0,\n"
           "counter-clockwise seen from outside. Raises ValueError for what does not fit.")
      .def_static(
          "read", [](const std::filesystem::path& path) { return cli::read_mesh_input(path).file.mesh; },
          py::arg("path"), py::call_guard<py::gil_scoped_release>(),
          "Reads an OBJ, PLY, OFF, STL, GLB or glTF file. Raises InputError.")
      .def_property_readonly(
          "positions",
          [](const py::object& mesh) { return view_of(mesh.cast<const Mesh&>().positions, mesh); },
          "#V x 3, in the file's units; read-only.")
      .def_property_readonly("faces", &faces_of, "#F arrays of vertex indices.")
      .def_property_readonly("groups", &groups_of, "Face indices by the group's name.")
      .def("__repr__", [](const Mesh& mesh) {
        return fmt::format("<flexkey.Mesh: {} vertices, {} faces>", mesh.vertex_count(), mesh.face_count());
      });
}

}  // namespace flexkey::python
