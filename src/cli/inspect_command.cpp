#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/mesh_input.h"
#include "flexkey/mesh/connectivity.h"
#include "flexkey/mesh/defects.h"
#include "flexkey/mesh/weld.h"

namespace flexkey::cli {
namespace {

using nlohmann::json;

json vec_json(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

/// Triangles, quads, and polygons of more corners.
std::array<int, 3> count_faces(const Mesh& mesh) {
  std::array<int, 3> counts{};
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::size_t corners = mesh.face(f).size();
    ++counts[corners <= 3 ? 0 : corners == 4 ? 1 : 2];
  }
  return counts;
}

json groups_json(const Mesh& mesh) {
  json groups = json::array();
  for (const Group& group : mesh.groups)
    groups.push_back({{"name", group.name}, {"faces", group.faces.size()}});
  return groups;
}

json materials_json(const Mesh& mesh) {
  json materials = json::array();
  for (std::size_t m = 0; m < mesh.materials.size(); ++m) {
    const auto faces = std::count(mesh.face_material.begin(), mesh.face_material.end(), static_cast<int>(m));
    materials.push_back(
        {{"name", mesh.materials[m].name}, {"faces", faces}, {"texture", mesh.materials[m].texture}});
  }
  return materials;
}

/// A number of vertices each, by their lowest vertex: what `component: N` takes.
json components_json(const Mesh& surface) {
  const Components components = find_components(surface);
  std::vector<int> vertices(static_cast<std::size_t>(components.count), 0);
  std::vector<Bounds> bounds;
  for (const int component : components.of_vertex)
    if (component >= 0) ++vertices[static_cast<std::size_t>(component)];
  return vertices;
}

json loops_json(const Mesh& surface) {
  json loops = json::array();
  for (const std::vector<int>& loop : boundary_loops(surface)) {
    double length = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec3 a = surface.positions.row(loop[k]), b = surface.positions.row(loop[(k + 1) % loop.size()]);
      length += (b - a).norm();
    }
    loops.push_back({{"vertices", loop.size()}, {"length", length}});
  }
  return loops;
}

json nodes_json(const MeshInput& input) {
  json nodes = json::array();
  if (!input.source) return nodes;
  for (const SolvedNode& node : input.source->nodes) {
    int vertices = 0;
    for (const SolvedPrimitive& primitive : node.primitives) vertices += primitive.vertex_count;
    nodes.push_back({{"name", node.name}, {"vertices", vertices}});
  }
  return nodes;
}

json describe_mesh(const std::filesystem::path& path, const MeshInput& input) {
  const Mesh& mesh = input.file.mesh;
  const Mesh surface = weld(mesh).surface;
  const auto [triangles, quads, polygons] = count_faces(mesh);
  const Bounds bounds = bounds_of(mesh.positions);
  json report{{"file", path.string()},
              {"vertices", mesh.vertex_count()},
              {"surface_vertices", surface.vertex_count()},
              {"edges", mesh_edges(surface).size()},
              {"faces", mesh.face_count()},
              {"triangles", triangles},
              {"quads", quads},
              {"polygons", polygons},
              {"texcoords", !mesh.corner_texcoord.empty()},
              {"creases", mesh.creases.size()},
              {"sharp_vertices", mesh.sharp_vertices.size()}};
  report["bounds"] = {
      {"min", vec_json(bounds.min)}, {"max", vec_json(bounds.max)}, {"diagonal", bounds.diagonal()}};
  report["groups"] = groups_json(mesh);
  report["materials"] = materials_json(mesh);
  report["nodes"] = nodes_json(input);
  report["animations"] = input.source ? json(input.source->animations) : json::array();
  report["components"] = components_json(surface);
  report["boundary_loops"] = loops_json(surface);
  report["defects"] = describe(find_defects(surface));
  report["warnings"] = input.file.warnings;
  return report;
}

std::string vector_text(const json& v) {
  return fmt::format("{:g} {:g} {:g}", v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
}

/// The first few of a list, a line each.
template <class Line>
void print_list(const char* heading, const json& list, const Line& line) {
  constexpr std::size_t most = 20;
  for (std::size_t k = 0; k < std::min(most, list.size()); ++k)
    print_result(fmt::format("{:<11} {}\n", k == 0 ? heading : "", line(list[k], k)));
  if (list.size() > most) print_result(fmt::format("{:<11} and {} more\n", "", list.size() - most));
}

void print_text(const json& report) {
  const auto number = [&](const char* key) { return report[key].get<long>(); };
  const json& bounds = report["bounds"];
  print_result(fmt::format("{}\n", report["file"].get<std::string>()));
  print_result(fmt::format("vertices    {} ({} where seams are welded), {} edges\n", number("vertices"),
                           number("surface_vertices"), number("edges")));
  print_result(fmt::format("faces       {}: {} triangles, {} quads, {} larger; {}\n", number("faces"),
                           number("triangles"), number("quads"), number("polygons"),
                           report["texcoords"].get<bool>() ? "with UVs" : "no UVs"));
  print_result(fmt::format("bounds      {} .. {}, diagonal {:g}\n", vector_text(bounds["min"]),
                           vector_text(bounds["max"]), bounds["diagonal"].get<double>()));
  if (number("creases") + number("sharp_vertices") > 0)
    print_result(
        fmt::format("sharp       {} edges, {} vertices\n", number("creases"), number("sharp_vertices")));
  const auto faces = [](const json& one, std::size_t) {
    return fmt::format("{:<20} {:>8} faces", one["name"].get<std::string>(), one["faces"].get<long>());
  };
  print_list("groups", report["groups"], faces);
  print_list("materials", report["materials"], faces);
  print_list("nodes", report["nodes"], [](const json& one, std::size_t) {
    return fmt::format("{:<20} {:>8} vertices", one["name"].get<std::string>(), one["vertices"].get<long>());
  });
  print_list("animations", report["animations"],
             [](const json& one, std::size_t) { return one.get<std::string>(); });
  print_list("components", report["components"], [](const json& one, std::size_t k) {
    return fmt::format("{:<20} {:>8} vertices", k, one.get<long>());
  });
  print_list("boundaries", report["boundary_loops"], [](const json& one, std::size_t) {
    return fmt::format("{} vertices, {:g} long", one["vertices"].get<long>(), one["length"].get<double>());
  });
  if (report["boundary_loops"].empty()) print_result("boundaries  none: the surface is closed\n");
  print_list("defects", report["defects"],
             [](const json& one, std::size_t) { return one.get<std::string>(); });
  if (report["defects"].empty()) print_result("defects     none\n");
}

}  // namespace

int run_inspect(const InspectOptions& options) {
  const MeshInput input = read_mesh_input(options.mesh);
  for (const std::string& warning : input.file.warnings) say(fmt::format("warning: {}\n", warning));
  const json report = describe_mesh(options.mesh, input);
  if (options.json) {
    print_result(fmt::format("{}\n", report.dump(2, ' ', false, json::error_handler_t::replace)));
  } else {
    print_text(report);
  }
  return done;
}

}  // namespace flexkey::cli
