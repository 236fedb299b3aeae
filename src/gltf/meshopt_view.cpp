#include "flexkey/gltf/meshopt_view.h"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

// The densest that the codec gets: two bits for sixteen bytes of a vertex's lanes.
constexpr std::size_t kBestRatio = 256;

void require(bool holds, const char* problem) {
  if (!holds) throw InputError(problem);
}

/// What the library itself only asserts.
void check_shape(const MeshoptView& view, std::size_t encoded_bytes) {
  const bool attributes = view.mode == "ATTRIBUTES";
  require(attributes || view.mode == "TRIANGLES" || view.mode == "INDICES", "its mode is unknown");
  if (attributes) {
    require(view.stride > 0 && view.stride <= 256 && view.stride % 4 == 0,
            "its stride is not a multiple of 4 up to 256");
  } else {
    require(view.stride == 2 || view.stride == 4, "its indices are neither 2 nor 4 bytes wide");
    require(view.mode == "INDICES" || view.count % 3 == 0, "its count is not a multiple of 3");
  }
  require(view.count > 0 && view.count <= kBestRatio * encoded_bytes / view.stride,
          "its count is more than its data can hold");
  if (view.filter == "NONE") return;
  require(attributes, "only attributes have filters");
  require(view.filter != "OCTAHEDRAL" || view.stride == 4 || view.stride == 8,
          "an octahedral filter has a stride of 4 or 8");
  require(view.filter != "QUATERNION" || view.stride == 8, "a quaternion filter has a stride of 8");
}

int decode(const MeshoptView& view, std::span<const unsigned char> encoded, void* decoded) {
  if (view.mode == "ATTRIBUTES")
    return meshopt_decodeVertexBuffer(decoded, view.count, view.stride, encoded.data(), encoded.size());
  if (view.mode == "TRIANGLES")
    return meshopt_decodeIndexBuffer(decoded, view.count, view.stride, encoded.data(), encoded.size());
  return meshopt_decodeIndexSequence(decoded, view.count, view.stride, encoded.data(), encoded.size());
}

void unfilter(const MeshoptView& view, void* decoded) {
  if (view.filter == "OCTAHEDRAL") {
    meshopt_decodeFilterOct(decoded, view.count, view.stride);
  } else if (view.filter == "QUATERNION") {
    meshopt_decodeFilterQuat(decoded, view.count, view.stride);
  } else if (view.filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(decoded, view.count, view.stride);
  } else if (view.filter != "NONE") {
    throw InputError("its filter is unknown");
  }
}

}  // namespace

std::vector<unsigned char> decode_meshopt(std::span<const unsigned char> encoded, const MeshoptView& view) {
  check_shape(view, encoded.size());
  std::vector<unsigned char> decoded(view.count * view.stride);
  if (const int error = decode(view, encoded, decoded.data()); error != 0)
    throw InputError(fmt::format("its data cannot be decoded (meshoptimizer's error {})", error));
  unfilter(view, decoded.data());
  return decoded;
}

}  // namespace flexkey
