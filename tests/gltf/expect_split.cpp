#include "gltf/expect_split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "gltf/shown.h"

namespace flexkey::testing {
namespace {

constexpr float kFps = 24;

using Place = std::array<float, 6>;

/// Position and normal of a vertex; of a primitive without normals zeros.
Place place_of(const FloatRows& positions, const FloatRows& normals, Eigen::Index v) {
  Place place{};
  for (Eigen::Index i = 0; i < 3; ++i) {
    place[static_cast<std::size_t>(i)] = positions(v, i);
    if (normals.rows() > 0) place[static_cast<std::size_t>(i) + 3] = normals(v, i);
  }
  return place;
}

std::set<int> named_by(const std::vector<std::array<int, 3>>& triangles) {
  std::set<int> vertices;
  for (const std::array<int, 3>& triangle : triangles) vertices.insert(triangle.begin(), triangle.end());
  return vertices;
}

/// How many places vertices with and without targets share; each must be one place at this time.
int expect_closed(const std::vector<ShownPrimitive>& shown) {
  std::map<Place, Place> still;
  int shared = 0;
  for (const bool has_targets : {false, true})
    for (const ShownPrimitive& one : shown)
      for (const int v : one.has_targets == has_targets ? named_by(one.triangles) : std::set<int>()) {
        const Place rest = place_of(one.rest, one.rest_normals, v);
        const Place posed = place_of(one.positions, one.normals, v);
        if (!has_targets) still[rest] = posed;
        if (!has_targets || !still.contains(rest)) continue;
        EXPECT_EQ(posed, still[rest]) << "vertex " << v;
        ++shared;
      }
  return shared;
}

double largest_difference(const ShownFile& a, const ShownFile& b, float seconds) {
  const auto first = triangles_of(a.at(seconds)), second = triangles_of(b.at(seconds));
  EXPECT_EQ(first.size(), second.size());
  double largest = 0;
  for (std::size_t t = 0; t < std::min(first.size(), second.size()); ++t) {
    EXPECT_EQ(first[t].first, second[t].first);
    for (std::size_t i = 0; i < 9; ++i)
      largest = std::max<double>(largest, std::abs(first[t].second[i] - second[t].second[i]));
  }
  return largest;
}

}  // namespace

void expect_same_but_split(const std::filesystem::path& split, const std::filesystem::path& whole, int frames,
                           double tolerance) {
  const ShownFile parted(split), one(whole);
  for (int k = 0; k < frames; ++k) {
    const float seconds = static_cast<float>(k) / kFps;
    EXPECT_GT(expect_closed(parted.at(seconds)), 0) << "no border at frame " << k;
    EXPECT_LE(largest_difference(parted, one, seconds), tolerance) << "frame " << k;
  }
}

}  // namespace flexkey::testing
