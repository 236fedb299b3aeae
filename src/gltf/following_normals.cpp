#include "flexkey/gltf/following_normals.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

namespace flexkey {
namespace {

std::size_t index(Eigen::Index i) {
  return static_cast<std::size_t>(i);
}

// Two nodes' normals of one direction differ by rounding.
constexpr double kSteps = 1024;

using Key = std::array<double, 6>;

Key key_of(const Vec3& position, const Vec3& normal) {
  Key key{};
  for (int i = 0; i < 3; ++i) {
    key[index(i)] = position[i] + 0.0;  // -0 becomes 0
    key[index(i) + 3] = std::round(kSteps * normal[i]) + 0.0;
  }
  return key;
}

/// A triangle's first edge, the direction across it and its normal, as columns; and its area. No frame where
/// it has no area.
struct Frame {
  Eigen::Matrix3d axes;
  double area = 0;
};

Frame frame_of(const Positions& positions, const std::array<int, 3>& triangle) {
  const Vec3 origin = positions.row(triangle[0]);
  const Vec3 along = positions.row(triangle[1]).transpose() - origin;
  const Vec3 normal = along.cross(positions.row(triangle[2]).transpose() - origin);
  Frame frame;
  frame.area = normal.norm() / 2;
  if (!(frame.area > 0)) return frame;
  frame.axes.col(0) = along.normalized();
  frame.axes.col(2) = normal.normalized();
  frame.axes.col(1) = frame.axes.col(2).cross(frame.axes.col(0));
  return frame;
}

}  // namespace

FollowingNormals::FollowingNormals(const Mesh& mesh, const GltfSource& source)
    : rest_(mesh.positions), normals_(source.normals), node_of_(index(mesh.vertex_count()), 0) {
  for (int f = 0; f < mesh.face_count(); ++f)
    triangles_.push_back({mesh.face(f)[0], mesh.face(f)[1], mesh.face(f)[2]});
  for (const SolvedNode& node : source.nodes) {
    const Eigen::Matrix3d linear = node.world.topLeftCorner<3, 3>();
    for (const SolvedPrimitive& primitive : node.primitives)
      std::fill_n(node_of_.begin() + primitive.first_vertex, primitive.vertex_count,
                  static_cast<int>(spaces_.size()));
    spaces_.push_back({linear.inverse().transpose(), linear.transpose()});
  }
  std::map<Key, int> sets;
  std::vector<Vec3> set_normals;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const Eigen::Matrix3d& to_scene = spaces_[index(node_of_[index(v)])].to_scene;
    const Vec3 normal = (to_scene * normals_.row(v).transpose()).normalized();
    const auto [entry, is_new] =
        sets.try_emplace(key_of(rest_.row(v), normal), static_cast<int>(sets.size()));
    if (is_new) set_normals.push_back(normal);
    set_of_.push_back(entry->second);
  }
  set_normals_.resize(static_cast<Eigen::Index>(set_normals.size()), 3);
  for (std::size_t set = 0; set < set_normals.size(); ++set)
    set_normals_.row(static_cast<Eigen::Index>(set)) = set_normals[set];
}

Positions FollowingNormals::at(const Positions& positions) const {
  Positions sums = Positions::Zero(set_normals_.rows(), 3);
  std::vector<bool> is_moved(index(set_normals_.rows()), false);
  for (const Triangle& triangle : triangles_) {
    const bool stays = std::all_of(triangle.begin(), triangle.end(),
                                   [&](int v) { return positions.row(v) == rest_.row(v); });
    const Frame rest = frame_of(rest_, triangle), pose = frame_of(positions, triangle);
    if (!(rest.area > 0) || !(pose.area > 0)) continue;
    const Eigen::Matrix3d turn = pose.axes * rest.axes.transpose();
    for (const int v : triangle) {
      const int set = set_of_[index(v)];
      sums.row(set) += pose.area * (turn * set_normals_.row(set).transpose()).transpose();
      if (!stays) is_moved[index(set)] = true;
    }
  }
  Positions result = normals_;
  for (Eigen::Index v = 0; v < result.rows(); ++v) {
    const int set = set_of_[index(v)];
    if (!is_moved[index(set)] || sums.row(set).isZero(0) || normals_.row(v).isZero(0)) continue;
    const NodeSpace& space = spaces_[index(node_of_[index(v)])];
    result.row(v) = (space.to_node * sums.row(set).transpose()).normalized().transpose();
  }
  return result;
}

}  // namespace flexkey
