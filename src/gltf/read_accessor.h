#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "flexkey/gltf/gltf_scene.h"

namespace flexkey {

using AccessorRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

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

  /// Vertex indices, each below `vertices`.
  std::vector<int> indices(int accessor, std::size_t vertices) const;

  std::size_t count(int accessor) const { return scene_.accessors[static_cast<std::size_t>(accessor)].count; }

 private:
  struct Elements;
  Elements elements(const std::string& what, int view, std::size_t offset, std::size_t count,
                    std::size_t element_bytes) const;
  void put_in_sparse(const std::string& what, const GltfAccessor& accessor, AccessorRows& rows) const;

  const GltfScene& scene_;
  std::span<const unsigned char> bytes_;
};

}  // namespace flexkey
