#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "flexkey/gltf/motion.h"

namespace flexkey {

/// The nearest point of a straight way between two shapes: in the mean of the vertices, 0 from .. 1 to.
double share_of_way(const Eigen::Ref<const ShapeRow>& shape, const Eigen::Ref<const ShapeRow>& from,
                    const Eigen::Ref<const ShapeRow>& to);

/// Rest; every other node of a walk is a target.
constexpr int kRestNode = 0;

/// When a walk is at a node. The frames since the visit before lie on the way from that one's node.
struct Visit {
  double frame = 0;  // index of a frame, which is then at the node, or between two
  int node = kRestNode;
  int towards =
      kRestNode;  // where the way leads: the node, or where the motion turned on its way and came back
  bool is_between_frames() const { return frame != std::floor(frame); }
};

/// A motion as a walk over straight ways between a few shapes, its nodes: a frame between two visits is a
/// blend of their two nodes. How fast it goes there is free, and it may come back to a node whenever its
/// shape returns, so that easing, holds, rest and ways back take no nodes of their own.
struct Walk {
  std::vector<int> origin;  // #nodes, the frame whose shape the node has at first; -1 for rest
  std::vector<Visit>
      visits;  // increasing frames; the first is at frame 0 or before, the last at the last or after
};

/// Walks greedily, each new node as far ahead as the way to it stays near the frames.
/// shapes: a row a frame, deltas from rest. reach: how far a frame may be from its way, and a node that is
/// come back to from the motion there.
Walk walk_along(const ShapeRows& shapes, double reach);

}  // namespace flexkey
