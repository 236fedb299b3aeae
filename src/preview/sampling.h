#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace flexkey {

/// What the random numbers of a pixel's samples are for; each use is independent of the others.
enum class Purpose : std::uint32_t { pixel, key, sky, reach };

/// The sample `index` of `count` of a pixel, in the unit square: a Hammersley set, shifted from pixel to
/// pixel (Cranley and Patterson 1976) and paired anew for each purpose. It depends on nothing else: neither
/// threads nor frames.
struct PixelSample {
  std::uint32_t x = 0, y = 0;
  int index = 0, count = 1;
  Eigen::Vector2f at(Purpose purpose) const;
};

/// A place in the unit square on the unit disc, areas kept (Shirley and Chiu 1997).
Eigen::Vector2f on_disc(const Eigen::Vector2f& square);

}  // namespace flexkey
