#pragma once

#include <array>
#include <bitset>
#include <limits>
#include <memory>

#include "flexkey/preview/drawn_frame.h"

namespace flexkey {

inline constexpr std::size_t kLanes = 16;

/// Rays that are traced together, a lane each.
struct Rays {
  using Lane = std::array<float, kLanes>;
  Lane origin_x{}, origin_y{}, origin_z{};
  Lane direction_x{}, direction_y{}, direction_z{};
  Lane reach{};  // how far along the unit direction
  std::bitset<kLanes> is_active;

  void set(std::size_t lane, const Ray& ray, float far = std::numeric_limits<float>::infinity());
};

using Hits = std::array<Hit, kLanes>;

/// The frame as a tree in which rays find what they meet. One tree is rebuilt for every frame, from the
/// frame alone, so that a frame's picture does not depend on those before.
class Tracer {
 public:
  explicit Tracer(const Surface& surface);
  ~Tracer();
  Tracer(Tracer&&) noexcept;
  Tracer& operator=(Tracer&&) noexcept;

  /// The frame's surface must be the constructor's.
  void update(const DrawnFrame& frame);

  /// What each active ray meets first.
  Hits first_hits(const Rays& rays) const;
  /// Which rays meet the surface within their reach; marks cast no shadow.
  std::bitset<kLanes> blocked(const Rays& rays) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace flexkey
