#pragma once

#include <vector>

#include "flexkey/preview/light.h"
#include "flexkey/preview/picture.h"

namespace flexkey {

/// The mean of what some samples found.
struct Mean {
  float sum = 0, weight = 0;

  void add(float value, float share) {
    sum += share * value;
    weight += share;
  }
};

/// The mean of a pixel's samples, with the noisy part, how much light came through, kept apart.
struct LitPixel {
  Response response;
  Mean key, sky;  // of the samples that asked; zero weight where none did
  Eigen::Vector3f position = Eigen::Vector3f::Zero(), normal = Eigen::Vector3f::Zero();
};

/// A traced picture before its noise is taken out.
struct Negative {
  int width = 0, height = 0;
  std::vector<LitPixel> pixels;  // rows from the top

  Negative(int across, int along);
  LitPixel& at(int x, int y) { return pixels[place(x, y)]; }
  const LitPixel& at(int x, int y) const { return pixels[place(x, y)]; }

 private:
  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

/// The picture. What came through of each light is averaged over neighbours on the same piece of surface
/// (Tomasi and Manduchi's bilateral filter, guided by position and normal); colours and outlines stay as they
/// were traced. With more samples a pixel less is averaged.
Picture develop(const Negative& negative, int samples);

}  // namespace flexkey
