#include "flexkey/gltf/measure.h"

#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "flexkey/gltf/accessors.h"

namespace flexkey {
namespace {

/// Rows of an attribute at target `frame` with weight 1, added up in floats.
Positions played(const tinygltf::Model& model, std::size_t primitive, const std::string& attribute,
                 std::size_t frame) {
  const tinygltf::Primitive& written = model.meshes[0].primitives[primitive];
  const FloatRows base = read_rows(model, written.attributes.at(attribute));
  const FloatRows sum = base + read_rows(model, written.targets[frame].at(attribute));
  return sum.cast<double>();
}

/// Sums over the vertices and frames seen so far.
class ErrorSums {
 public:
  void add_positions(const Positions& solved, const Positions& played) {
    const Positions off = solved - played;
    largest_ = std::max(largest_, off.rowwise().norm().maxCoeff());
    off_squared_ += off.squaredNorm();
    spread_squared_ += (solved.rowwise() - solved.colwise().mean()).squaredNorm();
  }

  void add_normals(const Positions& solved, const Positions& played) {
    for (Eigen::Index row = 0; row < solved.rows(); ++row) {
      const Vec3 a = solved.row(row), b = played.row(row);
      const double angle = std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
      angle_sum_ += angle;
      largest_angle_ = std::max(largest_angle_, angle);
      ++angles_;
    }
  }

  PlaybackError result(double diagonal) const {
    PlaybackError error;
    error.largest = diagonal > 0 ? largest_ / diagonal : 0;
    error.kg = spread_squared_ > 0 ? 100 * std::sqrt(off_squared_ / spread_squared_) : 0;
    error.has_normals = angles_ > 0;
    error.normal_mean = angles_ > 0 ? angle_sum_ / static_cast<double>(angles_) : 0;
    error.normal_largest = largest_angle_;
    return error;
  }

 private:
  double largest_ = 0, off_squared_ = 0, spread_squared_ = 0;
  double angle_sum_ = 0, largest_angle_ = 0;
  std::int64_t angles_ = 0;
};

/// The rows of all primitives one below the other.
Positions stacked(const std::vector<Positions>& parts) {
  Eigen::Index rows = 0;
  for (const Positions& part : parts) rows += part.rows();
  Positions all(rows, 3);
  rows = 0;
  for (const Positions& part : parts) {
    all.middleRows(rows, part.rows()) = part;
    rows += part.rows();
  }
  return all;
}

}  // namespace

PlaybackError measure_playback(const tinygltf::Model& model, const Clip& clip,
                               const std::vector<Primitive>& primitives,
                               const std::optional<SeamlessNormals>& normals) {
  const auto solved_parts = [&](const Positions& rows) {
    std::vector<Positions> parts;
    for (const Primitive& primitive : primitives) parts.push_back(rows(primitive.vertices, Eigen::all));
    return stacked(parts);
  };
  const auto played_parts = [&](const std::string& attribute, std::size_t frame) {
    std::vector<Positions> parts;
    for (std::size_t i = 0; i < primitives.size(); ++i) parts.push_back(played(model, i, attribute, frame));
    return stacked(parts);
  };
  ErrorSums sums;
  for (std::size_t frame = 0; frame < clip.frames.size(); ++frame) {
    const Positions& solved = clip.frames[frame];
    sums.add_positions(solved_parts(solved), played_parts("POSITION", frame));
    if (normals) sums.add_normals(solved_parts(normals->at(solved)), played_parts("NORMAL", frame));
  }
  return sums.result(bounds_of(clip.mesh.positions).diagonal());
}

}  // namespace flexkey
