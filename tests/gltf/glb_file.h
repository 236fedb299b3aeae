#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace flexkey::testing {

/// Reads a GLB with tinygltf; a failure fails the test. Images stay undecoded.
tinygltf::Model load_glb(const std::filesystem::path& path);

/// All rows of an accessor of any component type, sparse ones filled in and normalized
/// integers as the numbers that they stand for: #rows x components.
Eigen::MatrixXd rows_of(const tinygltf::Model& model, int accessor);

/// Bytes that an accessor takes in the buffer.
std::size_t stored_bytes(const tinygltf::Model& model, int accessor);

/// The weights that the first animation gives its mesh, interpolated as LINEAR samplers are, before the first
/// key and after the last one held.
std::vector<float> weights_at(const tinygltf::Model& model, float seconds);

/// base + sum of weight x delta in floats, as clients compute it: #vertices x 3.
Eigen::MatrixXf morphed(const tinygltf::Model& model, std::size_t primitive, const std::string& attribute,
                        const std::vector<float>& weights);

}  // namespace flexkey::testing
