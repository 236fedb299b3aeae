#include "flexkey/gltf/materials.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>

#include "flexkey/gltf/accessors.h"
#include "flexkey/gltf/utf8.h"

namespace flexkey {
namespace {

constexpr double kRoughness = 0.8;

/// The value held to 0..1; what is no number counts as 0.
double share(double value) {
  return value > 0 ? std::min(value, 1.0) : 0.0;
}

void append_texture(tinygltf::Model& model, const Texture& texture) {
  tinygltf::Image image;
  image.name = texture.name;
  image.mimeType = texture.mime_type;
  image.bufferView = append_bytes(model, texture.bytes);
  tinygltf::Texture reference;
  reference.source = static_cast<int>(model.images.size());
  model.images.push_back(std::move(image));
  model.textures.push_back(std::move(reference));
}

tinygltf::Material pbr_material(const Material& material) {
  tinygltf::Material result;
  result.name = valid_utf8(material.name);
  // OBJ knows no back-face culling, and an open surface would show holes with it.
  result.doubleSided = true;
  result.alphaMode = share(material.opacity) < 1 ? "BLEND" : "OPAQUE";
  auto& pbr = result.pbrMetallicRoughness;
  for (int i = 0; i < 3; ++i) {
    pbr.baseColorFactor[static_cast<std::size_t>(i)] = linear_from_srgb(material.base_color[i]);
  }
  pbr.baseColorFactor[3] = share(material.opacity);
  pbr.metallicFactor = 0;
  pbr.roughnessFactor = kRoughness;
  return result;
}

}  // namespace

double linear_from_srgb(double channel) {
  const double c = share(channel);
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double srgb_from_linear(double channel) {
  const double c = share(channel);
  return c <= 0.0031308 ? c * 12.92 : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

void append_materials(tinygltf::Model& model, const Mesh& mesh, const std::vector<Primitive>& primitives,
                      const TextureSet& textures) {
  for (const Texture& texture : textures.textures) append_texture(model, texture);
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const int index = primitives[i].material;
    // glTF's own default material is a black mirror in most viewers, so faces without one get OBJ's grey.
    Material material;
    material.name = "default";
    if (index >= 0) material = mesh.materials[static_cast<std::size_t>(index)];
    model.materials.push_back(pbr_material(material));
    model.materials.back().pbrMetallicRoughness.baseColorTexture.index = textures.of_primitive[i];
  }
}

}  // namespace flexkey
