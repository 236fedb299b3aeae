#include "flexkey/preview/images/palette.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace flexkey {
namespace {

using Sample = ColourCount::Sample;
using Samples = std::span<Sample>;

constexpr int lloyd_steps = 8;

/// Weighted sums over samples: enough for their mean and their spread.
struct Moments {
  double weight = 0;
  std::array<double, 3> first{}, second{};
  void add(const Sample& sample) {
    weight += sample.weight;
    for (std::size_t c = 0; c < 3; ++c) {
      first[c] += sample.weight * sample.colour[c];
      second[c] += sample.weight * sample.colour[c] * sample.colour[c];
    }
  }
  /// Summed squared distances from the mean along a channel.
  double spread(std::size_t c) const { return second[c] - first[c] * first[c] / weight; }
  Srgb mean() const {
    return {static_cast<float>(first[0] / weight), static_cast<float>(first[1] / weight),
            static_cast<float>(first[2] / weight)};
  }
};

Moments moments_of(Samples samples) {
  Moments moments;
  for (const Sample& sample : samples) moments.add(sample);
  return moments;
}

struct Box {
  Samples samples;
  Srgb mean{};
  std::size_t widest = 0;  // channel
  double spread = 0;       // along it
};

Box box_of(Samples samples) {
  const Moments moments = moments_of(samples);
  Box box{samples, moments.mean()};
  for (std::size_t c = 0; c < 3; ++c) {
    if (moments.spread(c) <= box.spread) continue;
    box.widest = c;
    box.spread = moments.spread(c);
  }
  return box;
}

/// The two halves of a box on either side of its mean; one of them is empty where nothing parts them.
std::array<Samples, 2> halves(const Box& box) {
  const auto below = [&](const Sample& sample) { return sample.colour[box.widest] < box.mean[box.widest]; };
  const auto middle = std::partition(box.samples.begin(), box.samples.end(), below);
  const auto first = static_cast<std::size_t>(middle - box.samples.begin());
  return {box.samples.first(first), box.samples.subspan(first)};
}

std::vector<Srgb> median_cut(Samples samples, std::size_t most) {
  std::vector<Box> boxes{box_of(samples)};
  const auto narrower = [](const Box& a, const Box& b) { return a.spread < b.spread; };
  while (boxes.size() < most) {
    const auto widest = std::max_element(boxes.begin(), boxes.end(), narrower);
    if (widest->spread < 1e-3) break;
    const std::array<Samples, 2> parts = halves(*widest);
    if (parts[0].empty() || parts[1].empty()) {  // equal but for rounding
      widest->spread = 0;
      continue;
    }
    *widest = box_of(parts[0]);
    boxes.push_back(box_of(parts[1]));
  }
  std::vector<Srgb> means;
  for (const Box& box : boxes) means.push_back(box.mean);
  return means;
}

float squared_distance(const Srgb& a, const Srgb& b) {
  const float red = a[0] - b[0], green = a[1] - b[1], blue = a[2] - b[2];
  return red * red + green * green + blue * blue;
}

void lloyd_step(Samples samples, std::vector<Srgb>& colours) {
  std::vector<Moments> near(colours.size());
  for (const Sample& sample : samples) {
    const auto closer = [&](const Srgb& a, const Srgb& b) {
      return squared_distance(a, sample.colour) < squared_distance(b, sample.colour);
    };
    near[static_cast<std::size_t>(std::min_element(colours.begin(), colours.end(), closer) - colours.begin())]
        .add(sample);
  }
  for (std::size_t i = 0; i < colours.size(); ++i)
    if (near[i].weight > 0) colours[i] = near[i].mean();
}

}  // namespace

ColourCount::ColourCount() : cells_(64 * 64 * 64) {}

void ColourCount::add(const std::vector<std::uint8_t>& rgb) {
  for (std::size_t i = 0; i < rgb.size(); i += 3) {
    const std::size_t index = (rgb[i] / 4u * 64u + rgb[i + 1] / 4u) * 64u + rgb[i + 2] / 4u;
    Cell& cell = cells_[index];
    ++cell.pixels;
    for (std::size_t c = 0; c < 3; ++c) cell.sum[c] += rgb[i + c];
  }
}

std::vector<Sample> ColourCount::samples() const {
  std::vector<Sample> samples;
  for (const Cell& cell : cells_) {
    if (cell.pixels == 0) continue;
    const auto pixels = static_cast<double>(cell.pixels);
    const auto mean = [&](std::size_t c) {
      return static_cast<float>(static_cast<double>(cell.sum[c]) / pixels);
    };
    samples.push_back({{mean(0), mean(1), mean(2)}, static_cast<float>(std::sqrt(pixels))});
  }
  return samples;
}

std::vector<Srgb> make_palette(std::vector<Sample> samples, std::size_t most) {
  if (samples.empty()) return {};
  std::vector<Srgb> colours = median_cut(samples, most);
  for (int step = 0; step < lloyd_steps; ++step) lloyd_step(samples, colours);
  for (Srgb& colour : colours)
    for (float& channel : colour) channel = std::round(channel);
  return colours;
}

}  // namespace flexkey
