#pragma once

#include "flexkey/preview/surface.h"

namespace flexkey {

/// Vertex normals of a surface whose points move: which triangles surround a vertex is found once.
class Normals {
 public:
  explicit Normals(const Surface& surface);

  /// Area-weighted unit normals, #vertices x 3; zero for a vertex without area. The sums run in one order,
  /// whatever the threads.
  Points at(const Points& points) const;

 private:
  std::vector<std::array<int, 3>> triangles_;
  std::vector<int> offsets_, around_;  // triangles around each vertex
};

}  // namespace flexkey
