#include "flexkey/preview/images/textures.h"

#include <cmath>
#include <map>
#include <memory>

#include "flexkey/mesh/error.h"
#include "flexkey/preview/images/image_file.h"

namespace flexkey {
namespace {

/// The image and the colour of a material; no image where it has none.
struct Skin {
  std::shared_ptr<const Picture> image;
  Rgb colour;
};

int wrapped(int place, int length) {
  return (place % length + length) % length;
}

/// The image repeats in both directions; between the middles of pixels it blends.
Rgb sample(const Picture& image, const Eigen::Vector2f& uv) {
  const float x = (uv.x() - std::floor(uv.x())) * static_cast<float>(image.width) - 0.5f;
  const float y = (1 - (uv.y() - std::floor(uv.y()))) * static_cast<float>(image.height) - 0.5f;
  const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
  const float across = x - static_cast<float>(left), down = y - static_cast<float>(top);
  const auto pixel = [&](int column, int row) {
    const auto place =
        static_cast<std::size_t>(wrapped(row, image.height)) * static_cast<std::size_t>(image.width) +
        static_cast<std::size_t>(wrapped(column, image.width));
    return Eigen::Map<const Rgb>(image.rgb.data() + 3 * place);
  };
  return (1 - down) * ((1 - across) * pixel(left, top) + across * pixel(left + 1, top)) +
         down * ((1 - across) * pixel(left, top + 1) + across * pixel(left + 1, top + 1));
}

}  // namespace

Textures load_textures(const Mesh& mesh, const std::filesystem::path& folder) {
  Textures textures;
  std::map<std::string, std::shared_ptr<const Picture>> images;
  std::vector<Skin> skins;
  for (const Material& material : mesh.materials) {
    if (!material.texture.empty() && !images.contains(material.texture)) {
      std::shared_ptr<const Picture>& image = images[material.texture];
      try {
        image = std::make_shared<const Picture>(read_picture(folder / material.texture));
      } catch (const InputError& error) {
        textures.warnings.emplace_back(error.what());
      }
    }
    const Rgb colour = from_srgb(material.base_color.cwiseMax(0).cwiseMin(1).cast<float>());
    skins.push_back({material.texture.empty() ? nullptr : images[material.texture], colour});
  }
  textures.lookup = [skins](int material, const Eigen::Vector2f& uv) -> Rgb {
    const Skin& skin = skins[static_cast<std::size_t>(material)];
    return skin.image && uv.allFinite() ? sample(*skin.image, uv) : skin.colour;
  };
  return textures;
}

}  // namespace flexkey
