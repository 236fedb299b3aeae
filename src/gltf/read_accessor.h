#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "flexkey/gltf/accessors.h"
#include "flexkey/gltf/gltf_scene.h"

namespace flexkey {

/// Reads the accessors of a scene from its bytes; nothing is read before its bounds are checked, and no more
/// is allocated than the bytes can mean. Every fault is an InputError such as "accessor 3 reaches beyond its
/// buffer view".
class AccessorReader {
 public:
  AccessorReader(const GltfScene& scene, std::span<const unsigned char> bytes)
      : scene_(scene), bytes_(bytes) {}

  /// All elements, #elements x columns, normalized integers as the numbers that they mean, sparse ones put
  /// in. Throws also for an accessor without `columns` columns, and for a value that is no finite number.
  AccessorRows rows(int accessor, int columns) const;

  /// Some elements as they stand in the file, sparse ones put in. Throws also for an accessor of matrices,
  /// and for an element that it has not.
  RawElements elements(int accessor, const std::vector<int>& chosen) const;

  /// Vertex indices, each below `vertices`.
  std::vector<int> indices(int accessor, std::size_t vertices) const;

  std::size_t count(int accessor) const { return scene_.accessors[static_cast<std::size_t>(accessor)].count; }

 private:
  struct Place;
  Place place_of(const std::string& what, int view, std::size_t offset, std::size_t count,
                 std::size_t element_bytes) const;
  struct Replaced {
    std::size_t element;
    const unsigned char* bytes;
  };
  std::vector<Replaced> replaced(const std::string& what, const GltfAccessor& accessor) const;

  const GltfScene& scene_;
  std::span<const unsigned char> bytes_;
};

}  // namespace flexkey
