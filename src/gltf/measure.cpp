#include "flexkey/gltf/measure.h"

#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <string>

#include "flexkey/gltf/accessors.h"

namespace flexkey {
namespace {

/// Sums over the vertices and frames seen so far.
class ErrorSums {
 public:
  void add_positions(const Positions& solved, const Positions& played) {
    add_largest(solved, played);
    off_squared_ += (solved - played).squaredNorm();
    spread_squared_ += (solved.rowwise() - solved.colwise().mean()).squaredNorm();
  }

  void add_largest(const Positions& solved, const Positions& played) {
    largest_ = std::max(largest_, (solved - played).rowwise().norm().maxCoeff());
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

/// The primitives' rows one below the other.
FloatRows stacked(const std::vector<FloatRows>& parts) {
  Eigen::Index rows = 0;
  for (const FloatRows& part : parts) rows += part.rows();
  FloatRows all(rows, 3);
  rows = 0;
  for (const FloatRows& part : parts) {
    all.middleRows(rows, part.rows()) = part;
    rows += part.rows();
  }
  return all;
}

/// An attribute of all meshes as it was written, the rows of their primitives one below the other; mesh 0
/// alone has targets.
class Morphed {
 public:
  Morphed(const tinygltf::Model& model, const std::string& attribute) {
    const std::vector<tinygltf::Primitive>& moving = model.meshes[0].primitives;
    std::vector<tinygltf::Primitive> all;
    for (const tinygltf::Mesh& mesh : model.meshes)
      all.insert(all.end(), mesh.primitives.begin(), mesh.primitives.end());
    const auto read = [&](const auto& primitives, const auto& accessor_of) {
      std::vector<FloatRows> parts;
      for (const tinygltf::Primitive& primitive : primitives)
        parts.push_back(read_rows(model, accessor_of(primitive).at(attribute)));
      return stacked(parts);
    };
    base_ = read(
        all, [](const tinygltf::Primitive& one) -> const auto& { return one.attributes; });
    for (std::size_t t = 0; t < moving[0].targets.size(); ++t)
      targets_.push_back(read(
          moving, [t](const tinygltf::Primitive& one) -> const auto& { return one.targets[t]; }));
  }

  /// base + Σ weight · delta, added up in floats as clients do. weights: #targets.
  Positions at(const Eigen::RowVectorXf& weights) const {
    FloatRows sum = base_;
    for (std::size_t t = 0; t < targets_.size(); ++t) {
      const float weight = weights[static_cast<Eigen::Index>(t)];
      if (weight != 0) sum.topRows(targets_[t].rows()) += weight * targets_[t];
    }
    return sum.cast<double>();
  }

 private:
  FloatRows base_;
  std::vector<FloatRows> targets_;
};

/// The clip between two of its frames, by their numbers.
class Solved {
 public:
  explicit Solved(const Clip& clip) : clip_(clip) {
    for (const FrameReport& report : clip.reports) numbers_.push_back(report.frame);
  }
  const std::vector<double>& numbers() const { return numbers_; }

  Positions at(double number) const {
    const auto found = std::lower_bound(numbers_.begin(), numbers_.end(), number);
    const auto after = static_cast<std::size_t>(found - numbers_.begin());
    if (*found == number) return clip_.frames[after];
    const double share = (number - numbers_[after - 1]) / (numbers_[after] - numbers_[after - 1]);
    return (1 - share) * clip_.frames[after - 1] + share * clip_.frames[after];
  }

 private:
  const Clip& clip_;
  std::vector<double> numbers_;
};

/// Those of the keys that are no frames.
std::vector<double> keys_between(const std::vector<double>& keys, const std::vector<double>& frames) {
  std::vector<double> between;
  std::set_difference(keys.begin(), keys.end(), frames.begin(), frames.end(), std::back_inserter(between));
  return between;
}

}  // namespace

Played played_by(const tinygltf::Model& model, const Asset& asset, const AssetSplit& split) {
  std::vector<int> vertices;
  for (const auto* primitives : {&split.moving, &split.still})
    for (const Primitive& primitive : *primitives)
      vertices.insert(vertices.end(), primitive.vertices.begin(), primitive.vertices.end());
  const auto player_of = [&model](const char* attribute) {
    return [&model, attribute]() -> Player {
      return [morphed = Morphed(model, attribute)](const Eigen::RowVectorXf& weights) {
        return morphed.at(weights);
      };
    };
  };
  Played played{{vertices, player_of("POSITION")}, {}, normals_of(asset)};
  if (asset.normals) played.normals = {vertices, player_of("NORMAL")};
  return played;
}

PlaybackError measure_playback(const Played& played, const Clip& clip, const Basis& basis, Steps& steps) {
  const Solved solved(clip);
  ErrorSums sums;
  const auto each = [&](const std::vector<double>& times, const Player& player, const auto& compare) {
    for (const double time : times)
      compare(solved.at(time), player(weights_at(basis, std::array{time}).cast<float>()));
  };
  {
    const std::vector<int>& vertices = played.positions.vertices;
    const Player player = played.positions.player();
    each(solved.numbers(), player, [&](const Positions& right, const Positions& shown) {
      sums.add_positions(right(vertices, Eigen::all), shown);
      steps.advance();
    });
    each(keys_between(basis.keys, solved.numbers()), player,
         [&](const Positions& right, const Positions& shown) {
           sums.add_largest(right(vertices, Eigen::all), shown);
         });
  }
  if (const std::vector<int>& vertices = played.normals.vertices; !vertices.empty()) {
    each(solved.numbers(), played.normals.player(), [&](const Positions& right, const Positions& shown) {
      sums.add_normals(played.solved_normals(right)(vertices, Eigen::all), shown);
      steps.advance();
    });
  }
  return sums.result(bounds_of(clip.mesh.positions).diagonal());
}

}  // namespace flexkey
