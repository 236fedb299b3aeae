#include "write_obj.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <set>
#include <stdexcept>

namespace flexkey::meshes {

namespace {

// Five decimals are plenty for models about one unit large; trailing zeros and -0 are left out.
std::string number(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.5f", x);
  std::string s = text.data();
  while (s.back() == '0') s.pop_back();
  if (s.back() == '.') s.pop_back();
  return s == "-0" ? "0" : s;
}

std::ofstream opened(const std::string& path) {
  std::ofstream out(path);
  if (!out) throw std::runtime_error("cannot write " + path);
  return out;
}

std::string group_of(const std::string& part) {
  return part.substr(0, part.find(':'));
}

std::string material_of(const std::string& part) {
  return part.substr(part.find(':') + 1);
}

// Parts in the order of their groups' first appearance, so that each group is written in one run.
std::vector<Index> parts_by_group(const QuadMesh& mesh) {
  std::map<std::string, Index> first;
  std::vector<Index> order(mesh.part_names.size());
  for (Index part = 0; part < order.size(); ++part) {
    order[part] = part;
    first.try_emplace(group_of(mesh.part_names[part]), part);
  }
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return first.at(group_of(mesh.part_names[a])) < first.at(group_of(mesh.part_names[b]));
  });
  return order;
}

void write_materials(const QuadMesh& mesh, const std::string& path,
                     const std::map<std::string, Colour>& colours) {
  std::ofstream out = opened(path);
  std::set<std::string> done;
  for (const std::string& part : mesh.part_names) {
    const std::string name = material_of(part);
    if (!done.insert(name).second) continue;
    const auto found = colours.find(name);
    const Colour c = found != colours.end() ? found->second : Colour{0.7, 0.7, 0.7};
    out << "newmtl " << name << "\nKd " << number(c[0]) << ' ' << number(c[1]) << ' ' << number(c[2])
        << "\nKs 0.1 0.1 0.1\nNs 20\n\n";
  }
}

}  // namespace

void write_obj(const QuadMesh& mesh, const std::string& dir, const std::string& name,
               const std::map<std::string, Colour>& colours) {
  write_materials(mesh, dir + "/" + name + ".mtl", colours);
  std::ofstream out = opened(dir + "/" + name + ".obj");
  out << "# flexkey sample mesh: " << name << "\n# " << mesh.vertices.size() << " vertices, "
      << mesh.faces.size() << " quads\nmtllib " << name << ".mtl\n";
  for (const Vec3& p : mesh.vertices)
    out << "v " << number(p.x()) << ' ' << number(p.y()) << ' ' << number(p.z()) << '\n';
  for (Index part : parts_by_group(mesh)) {
    const std::string& label = mesh.part_names[part];
    out << "g " << group_of(label) << "\nusemtl " << material_of(label) << '\n';
    for (Index f = 0; f < mesh.faces.size(); ++f) {
      if (mesh.parts[f] != part) continue;
      out << 'f';
      for (Index v : mesh.faces[f]) out << ' ' << v + 1;
      out << '\n';
    }
  }
}

}  // namespace flexkey::meshes
