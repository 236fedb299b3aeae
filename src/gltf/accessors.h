#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "flexkey/gltf/float_rows.h"

namespace tinygltf {
class Model;
}

namespace flexkey {

// Each of these appends an array to buffer 0 of the model, in a buffer view of its own at a multiple of 4
// bytes, so that no view needs a stride, and returns the index of the new accessor. Accessors of floats get
// their exact smallest and largest values.

/// Vertex attribute, every row written.
int append_attribute(tinygltf::Model& model, const FloatRows& rows);

/// Morph deltas: sparse over zeros where that takes fewer bytes, else every row.
int append_deltas(tinygltf::Model& model, const SparseRows& rows);

/// Key times of an animation, seconds, #keys x 1.
int append_times(tinygltf::Model& model, const FloatRows& times);

/// Values of an animation: sparse over zeros where that takes fewer bytes, else every row.
int append_samples(tinygltf::Model& model, const SparseRows& rows);

/// Triangle corners, 16 bits wide where they fit; 65535 is left free, since it restarts primitives.
int append_triangles(tinygltf::Model& model, std::span<const std::uint32_t> corners);

/// Bytes as they are, such as an image's. Returns the index of the buffer view.
int append_bytes(tinygltf::Model& model, std::span<const std::byte> bytes);

/// All rows of a float accessor as the buffer holds them.
FloatRows read_rows(const tinygltf::Model& model, int accessor);

}  // namespace flexkey
