#include "flexkey/deform/polygon_cut.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace flexkey {
namespace {

/// What is left of a polygon: each corner with the corners beside it.
class Remainder {
 public:
  Remainder(const Positions& positions, std::span<const int> face)
      : positions_(positions), face_(face), before_(face.size()), after_(face.size()) {
    const std::size_t n = face.size();
    for (std::size_t k = 0; k < n; ++k) {
      before_[k] = (k + n - 1) % n;
      after_[k] = (k + 1) % n;
    }
    for (std::size_t k = 0; k < n; ++k) ears_.insert(ear(k));
  }

  std::size_t corner_count() const { return ears_.size(); }
  std::size_t best_ear() const { return std::get<3>(*ears_.begin()); }
  std::array<int, 3> triangle_at(std::size_t k) const {
    return {face_[before_[k]], face_[k], face_[after_[k]]};
  }

  void cut(std::size_t k) {
    const std::size_t left = before_[k], right = after_[k];
    for (const std::size_t corner : {left, k, right}) ears_.erase(ear(corner));
    after_[left] = right;
    before_[right] = left;
    for (const std::size_t corner : {left, right}) ears_.insert(ear(corner));
  }

 private:
  /// The squared length of the cut, the vertices that it joins, and the corner that it cuts off.
  using Ear = std::tuple<double, int, int, std::size_t>;
  Ear ear(std::size_t k) const {
    const int a = face_[before_[k]], b = face_[after_[k]];
    return {(positions_.row(a) - positions_.row(b)).squaredNorm(), std::min(a, b), std::max(a, b), k};
  }

  const Positions& positions_;
  std::span<const int> face_;
  std::vector<std::size_t> before_, after_;
  std::set<Ear> ears_;
};

}  // namespace

std::vector<std::array<int, 3>> cut_polygon(const Positions& positions, std::span<const int> face) {
  std::vector<std::array<int, 3>> triangles;
  const auto keep = [&](const std::array<int, 3>& t) {
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
  };
  if (face.size() == 3) keep({face[0], face[1], face[2]});
  if (face.size() <= 3) return triangles;
  Remainder remainder(positions, face);
  while (remainder.corner_count() > 3) {
    const std::size_t ear = remainder.best_ear();
    keep(remainder.triangle_at(ear));
    remainder.cut(ear);
  }
  keep(remainder.triangle_at(remainder.best_ear()));
  return triangles;
}

}  // namespace flexkey
