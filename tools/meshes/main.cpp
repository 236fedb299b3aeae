// Writes the sample meshes: make_meshes OUT_DIR

#include "models.h"
#include "quality.h"

#include <exception>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

int main(int argc, char** argv) {
  using namespace flexkey::meshes;
  if (argc < 2) {
    std::cerr << "usage: make_meshes OUT_DIR [NAME...]\n";
    return 2;
  }
  const std::vector<std::string> wanted(argv + 2, argv + argc);
  const std::vector<std::pair<std::string, std::function<Model()>>> makers{
      {"head", make_head},
      {"pig", make_pig},
      {"dragon", make_dragon},
      {"bar", [] { return make_bar(4.0, 10, 40); }},
      {"bar_20", [] { return make_bar(20.0, 4, 80); }},
  };
  try {
    for (const auto& [name, make] : makers) {
      bool take = wanted.empty();
      for (const std::string& w : wanted) take = take || w == name;
      if (!take) continue;
      const Model model = make();
      const Quality quality = measure(model.mesh);
      std::cout << report(name, model.mesh, quality);
      if (!quality.closed || !quality.single || !quality.fans || quality.volume <= 0.0)
        throw std::runtime_error(name + " is not one closed, outward-facing surface");
      write_obj(model.mesh, argv[1], name, model.colours);
    }
  } catch (const std::exception& error) {
    std::cerr << "make_meshes: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
