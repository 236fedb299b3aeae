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

/// The two parts of a box, cut where their means lie farthest apart for their weights (Otsu's criterion), so
/// that a few pixels of another colour come off whole. One part is empty where nothing parts them.
std::array<Samples, 2> cut(const Box& box) {
  const std::size_t c = box.widest;
  std::sort(box.samples.begin(), box.samples.end(), [&](const Sample& a, const Sample& b) {
    return a.colour[c] != b.colour[c] ? a.colour[c] < b.colour[c] : a.colour < b.colour;
  });
  const Moments all = moments_of(box.samples);
  double weight = 0, sum = 0, most = 0;
  std::size_t best = 0;
  for (std::size_t i = 0; i + 1 < box.samples.size(); ++i) {
    weight += box.samples[i].weight;
    sum += box.samples[i].weight * box.samples[i].colour[c];
    const double rest = all.first[c] - sum;
    const double apart = sum * sum / weight + rest * rest / (all.weight - weight);
    if (apart <= most || box.samples[i].colour[c] == box.samples[i + 1].colour[c]) continue;
    most = apart;
    best = i + 1;
  }
  return {box.samples.first(best), box.samples.subspan(best)};
}

std::vector<Srgb> cut_boxes(Samples samples, std::size_t most) {
  std::vector<Box> boxes{box_of(samples)};
  const auto narrower = [](const Box& a, const Box& b) { return a.spread < b.spread; };
  while (boxes.size() < most) {
    const auto widest = std::max_element(boxes.begin(), boxes.end(), narrower);
    if (widest->spread < 1e-3) break;
    const std::array<Samples, 2> parts = cut(*widest);
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
  std::vector<Srgb> colours = cut_boxes(samples, most);
  for (int step = 0; step < lloyd_steps; ++step) lloyd_step(samples, colours);
  for (Srgb& colour : colours)
    for (float& channel : colour) channel = std::round(channel);
  return colours;
}

}  // namespace flexkey
