#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "flexkey/gltf/float_rows.h"

namespace tinygltf {
class Model;
}

namespace flexkey {

/// Numbers of an accessor, #elements x components.
using AccessorRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Elements of an accessor as they are stored.
struct RawElements {
  int component_type = 0;  // as OpenGL numbers them: 5120 signed byte .. 5126 float
  int columns = 0;         // 1 SCALAR .. 4 VEC4
  bool normalized = false;
  std::vector<unsigned char> bytes;  // an element after another, each padded to a multiple of 4 bytes
  AccessorRows values;               // integers as they stand
};

// Each of these appends an array to buffer 0 of the model, in a buffer view of its own at a multiple of 4
// bytes, so that no view needs a stride, and returns the index of the new accessor. Accessors of floats get
// their exact smallest and largest values.

/// Vertex attribute, every row written.
int append_attribute(tinygltf::Model& model, const FloatRows& rows);

/// Vertex attribute of any component type, byte for byte.
int append_elements(tinygltf::Model& model, const RawElements& elements);

/// Morph deltas: sparse over zeros where that takes fewer bytes, else every row.
int append_deltas(tinygltf::Model& model, const SparseRows& rows);

/// Integers of −largest … largest that stand for −1 … 1, largest being 127 (one byte a number) or 32767
/// (two): #rows x 3, in a view whose stride is a multiple of 4 bytes, as vertex attributes want it.
int append_normalized(tinygltf::Model& model, const ShortRows& rows, int largest);

/// Key times of an animation, seconds, #keys x 1.
int append_times(tinygltf::Model& model, const FloatRows& times);

/// Values of an animation: sparse over zeros where that takes fewer bytes, else every row.
int append_samples(tinygltf::Model& model, const SparseRows& rows);

/// The same, every row written: #keys x 3 or, of quaternions, x 4.
int append_values(tinygltf::Model& model, const FloatRows& values);

/// Triangle corners, 16 bits wide where they fit; 65535 is left free, since it restarts primitives.
int append_triangles(tinygltf::Model& model, std::span<const std::uint32_t> corners);

/// Bytes as they are, such as an image's. Returns the index of the buffer view.
int append_bytes(tinygltf::Model& model, std::span<const std::byte> bytes);

/// All rows of an accessor that one of these appended, integers as the numbers that they stand for.
FloatRows read_rows(const tinygltf::Model& model, int accessor);

}  // namespace flexkey
