#include "flexkey/gltf/walk.h"

#include <algorithm>
#include <optional>

namespace flexkey {
namespace {

using Row = Eigen::Ref<const ShapeRow>;

class Walker {
 public:
  Walker(const ShapeRows& shapes, double reach)
      : shapes_(shapes), frames_(static_cast<int>(shapes.rows())), reach_(reach) {
    walk_.origin.push_back(-1);
    nodes_.push_back(ShapeRow::Zero(shapes.cols()));
  }

  Walk walk() {
    if (largest_length(shapes_.row(0)) <= reach_) {
      walk_.visits.push_back({-1, kRestNode, kRestNode});
    } else {
      make_node(0);
    }
    while (next_ < frames_) step();
    return std::move(walk_);
  }

 private:
  /// A way on from the present node: `next` is the first frame that it does not hold.
  struct Way {
    Visit end;
    int next = 0;
  };

  int here() const { return walk_.visits.back().node; }
  const ShapeRow& shape_of(int node) const { return nodes_[static_cast<std::size_t>(node)]; }

  void step() {
    const int ahead = farthest_ahead();
    const std::optional<Way> known = longest_known_way();
    if (known && (known->end.node != here() || known->next > ahead)) {
      walk_.visits.push_back(known->end);
      next_ = known->next;
    } else {
      make_node(ahead);
    }
  }

  void make_node(int frame) {
    const int node = static_cast<int>(nodes_.size());
    walk_.visits.push_back({static_cast<double>(frame), node, node});
    walk_.origin.push_back(frame);
    nodes_.emplace_back(shapes_.row(frame));
    next_ = frame + 1;
  }

  bool is_on_way(int frame, const Row& to) const {
    const ShapeRow& from = shape_of(here());
    const double share = share_of_way(shapes_.row(frame), from, to);
    return largest_length(shapes_.row(frame) - (1 - share) * from - share * to) <= reach_;
  }

  /// Whether a new node at this frame holds all frames before it.
  bool holds(int frame) const {
    for (int k = next_; k < frame; ++k) {
      if (!is_on_way(k, shapes_.row(frame))) return false;
    }
    return true;
  }

  /// The last frame whose node holds all before it: found by doubling, then halving, the step.
  int farthest_ahead() const {
    int good = next_, stride = 1;
    while (good + stride < frames_ && holds(good + stride)) {
      good += stride;
      stride *= 2;
    }
    for (; stride > 0; stride /= 2) {
      if (good + stride < frames_ && holds(good + stride)) good += stride;
    }
    return good;
  }

  /// When a node is met at the last frame of a way, or between it and the first that is not on the way.
  std::optional<double> crossing(int frame, int node) const {
    constexpr double soonest = 0.01;  // frames between two keys, so that their times differ as floats too
    const auto before = shapes_.row(frame - 1), after = shapes_.row(frame);
    const double to = (shape_of(node) - before).norm(), from = (after - shape_of(node)).norm();
    const double share = to > 0 ? to / (to + from) : 0;
    const bool is_between = share >= soonest && share <= 1 - soonest;
    const double when = is_between ? frame - 1 + share : frame - 1;
    const ShapeRow off = shape_of(node) - before - (when - (frame - 1)) * (after - before);
    if (largest_length(off) > reach_) return std::nullopt;
    return when;
  }

  std::optional<Way> way_to(int node) const {
    int next = next_;
    while (next < frames_ && is_on_way(next, shape_of(node))) ++next;
    if (next == next_) return std::nullopt;
    if (next == frames_) return Way{{static_cast<double>(frames_), node, node}, next};
    for (const int end : {node, here()}) {
      if (const std::optional<double> when = crossing(next, end)) return Way{{*when, end, node}, next};
    }
    return std::nullopt;
  }

  std::optional<Way> longest_known_way() const {
    std::optional<Way> longest;
    for (int node = 0; node < static_cast<int>(nodes_.size()); ++node) {
      if (node == here()) continue;
      const std::optional<Way> way = way_to(node);
      if (way && (!longest || way->next > longest->next)) longest = way;
    }
    return longest;
  }

  const ShapeRows& shapes_;
  int frames_;
  double reach_;
  Walk walk_;
  std::vector<ShapeRow> nodes_;
  int next_ = 0;  // first frame that has no place yet
};

}  // namespace

double share_of_way(const Row& shape, const Row& from, const Row& to) {
  const double squared = (to - from).squaredNorm();
  return squared > 0 ? std::clamp((shape - from).dot(to - from) / squared, 0.0, 1.0) : 0.0;
}

Walk walk_along(const ShapeRows& shapes, double reach) {
  return Walker(shapes, reach).walk();
}

}  // namespace flexkey
