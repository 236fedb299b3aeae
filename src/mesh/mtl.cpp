#include "flexkey/mesh/mtl.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>

#include "flexkey/mesh/read_file.h"

namespace flexkey {

std::vector<Material> parse_mtl(const std::string& bytes) {
  std::istringstream text(bytes);
  std::map<std::string, int> index_by_name;
  std::vector<tinyobj::material_t> parsed;
  std::string warning, error;
  tinyobj::LoadMtl(&index_by_name, &parsed, &text, &warning, &error);

  std::vector<Material> materials;
  for (const tinyobj::material_t& source : parsed) {
    if (source.name.empty()) continue;
    Material material;
    material.name = source.name;
    for (int k = 0; k < 3; ++k)
      material.base_color[k] = std::clamp<double>(static_cast<double>(source.diffuse[k]), 0.0, 1.0);
    material.opacity = std::clamp<double>(static_cast<double>(source.dissolve), 0.0, 1.0);
    material.texture = source.diffuse_texname;
    materials.push_back(std::move(material));
  }
  return materials;
}

std::vector<Material> read_mtl(const std::filesystem::path& path) {
  return parse_mtl(read_file(path));
}

}  // namespace flexkey
