#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace flexkey {

/// How EXT_meshopt_compression stores a buffer view.
struct MeshoptView {
  std::string mode;    // "ATTRIBUTES", "TRIANGLES" or "INDICES"
  std::string filter;  // "NONE", "OCTAHEDRAL", "QUATERNION" or "EXPONENTIAL"
  std::size_t count = 0;
  std::size_t stride = 0;  // bytes of an element
};

/// The view's bytes, count x stride. Throws InputError with the reason for what the extension's rules forbid,
/// for data that cannot be decoded, and for a count that they cannot hold.
std::vector<unsigned char> decode_meshopt(std::span<const unsigned char> encoded, const MeshoptView& view);

}  // namespace flexkey
