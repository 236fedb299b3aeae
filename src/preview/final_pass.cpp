#include "flexkey/preview/final_pass.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "flexkey/preview/negative.h"
#include "flexkey/preview/sampling.h"

namespace flexkey {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr int kTile = 16;            // pixels a side
constexpr float kLift = 2e-4f;       // keeps rays off the triangle that they start from
constexpr float kSkyReach = 0.35f;   // from here on nothing dims the sky
constexpr float kFloorGlow = 0.45f;  // what the floor gives back of the sky that it hides

/// What a sample sees.
struct Seen {
  enum class What { backdrop, ground, solid };
  What what = What::backdrop;
  Spot spot;
};

struct Samples {
  std::array<PixelSample, kLanes> lanes;
  std::size_t count = 0;
};

/// A place in the unit square under a tent two pixels wide, which hides noise better than a box.
Vector2f tent(const Vector2f& square) {
  const auto bend = [](float u) { return u < 0.5f ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u); };
  return {bend(square.x()), bend(square.y())};
}

Ray camera_ray(const View& view, const PixelSample& sample) {
  const Vector2f place = Vector2f(static_cast<float>(sample.x), static_cast<float>(sample.y)) +
                         Vector2f(0.5f, 0.5f) + 0.8f * tent(sample.at(Purpose::pixel));
  return {view.origin, view.direction(place.x(), place.y())};
}

Seen ground_seen(const Light& light, const Ray& ray) {
  Seen seen;
  const float distance = ground_distance(light, ray);
  const Vector3f position = ray.origin + distance * ray.direction;
  if (distance < 0 || position.norm() > kGroundEdge) return seen;
  seen.what = Seen::What::ground;
  seen.spot.position = position;
  seen.spot.normal = seen.spot.face = light.up;
  return seen;
}

std::array<Seen, kLanes> look(const Studio& studio, const Tracer& tracer, const Samples& samples) {
  std::array<Ray, kLanes> rays;
  Rays bundle;
  for (std::size_t k = 0; k < samples.count; ++k) {
    rays[k] = camera_ray(studio.view, samples.lanes[k]);
    bundle.set(k, rays[k]);
  }
  const Hits hits = tracer.first_hits(bundle);
  std::array<Seen, kLanes> seen;
  for (std::size_t k = 0; k < samples.count; ++k) {
    if (hits[k].what == Hit::What::nothing) {
      seen[k] = ground_seen(studio.light, rays[k]);
    } else {
      seen[k] = {Seen::What::solid, spot_at(studio.frame, studio.view, hits[k], rays[k])};
    }
  }
  return seen;
}

Ray leaving(const Spot& spot, const Vector3f& direction) {
  return {spot.position + kLift * spot.face, direction};
}

Vector3f key_direction(const Light& light, const PixelSample& sample) {
  const Vector2f disc = on_disc(sample.at(Purpose::key));
  return (light.key + disc.x() * light.key_side + disc.y() * light.key_front).normalized();
}

/// A direction of the hemisphere around the normal, as often as its cosine says (Malley's method), turned off
/// the triangle itself.
Vector3f sky_direction(const Spot& spot, const PixelSample& sample) {
  const Vector2f disc = on_disc(sample.at(Purpose::sky));
  const Vector3f side = spot.normal.unitOrthogonal(), front = spot.normal.cross(side);
  const float height = std::sqrt(std::max(1 - disc.squaredNorm(), 0.0f));
  Vector3f direction = disc.x() * side + disc.y() * front + height * spot.normal;
  const float above = direction.dot(spot.face);
  if (above < 0) direction -= 2 * above * spot.face;
  return direction;
}

/// What the rays to the light of some samples have found; a lane that asked for none counts as reached.
struct Gathered {
  std::array<Reached, kLanes> reached;
  std::bitset<kLanes> has_key, has_sky;  // lanes that asked
};

/// One ray to the key light, and one to the sky whose reach is drawn from 0 to kSkyReach, so that nearer
/// things dim it more.
Gathered gather(const Studio& studio, const Tracer& tracer, const Samples& samples,
                const std::array<Seen, kLanes>& seen) {
  Rays to_key, to_sky;
  Gathered gathered;
  for (std::size_t k = 0; k < samples.count; ++k) {
    const Spot& spot = seen[k].spot;
    if (seen[k].what == Seen::What::backdrop || !spot.is_lit) continue;
    const Vector3f key = key_direction(studio.light, samples.lanes[k]);
    if (key.dot(spot.normal) > 0) to_key.set(k, leaving(spot, key));
    const Ray sky = leaving(spot, sky_direction(spot, samples.lanes[k]));
    const float reach = kSkyReach * samples.lanes[k].at(Purpose::reach).x();
    to_sky.set(k, sky, reach);
    const float floor = ground_distance(studio.light, sky);
    if (seen[k].what == Seen::What::solid && floor >= 0 && floor < reach)
      gathered.reached[k].sky = kFloorGlow;
  }
  gathered.has_key = to_key.is_active;
  gathered.has_sky = to_sky.is_active;
  const std::bitset<kLanes> no_key = tracer.blocked(to_key), no_sky = tracer.blocked(to_sky);
  for (std::size_t k = 0; k < samples.count; ++k) {
    if (no_key[k]) gathered.reached[k].key = 0;
    if (no_sky[k]) gathered.reached[k].sky = 0;
  }
  return gathered;
}

Response response_of(const Studio& studio, const PixelSample& sample, const Seen& seen) {
  if (seen.what == Seen::What::solid) return spot_response(studio.light, seen.spot);
  const Rgb behind = backdrop(studio.view, static_cast<int>(sample.x), static_cast<int>(sample.y));
  if (seen.what == Seen::What::ground) return ground_response(behind, seen.spot.position.norm());
  return {behind, Rgb::Zero(), Rgb::Zero()};
}

void add_samples(const Studio& studio, const Tracer& tracer, const Samples& samples, Negative& negative) {
  const std::array<Seen, kLanes> seen = look(studio, tracer, samples);
  const Gathered light = gather(studio, tracer, samples, seen);
  for (std::size_t k = 0; k < samples.count; ++k) {
    const PixelSample& sample = samples.lanes[k];
    LitPixel& pixel = negative.at(static_cast<int>(sample.x), static_cast<int>(sample.y));
    const float share = 1 / static_cast<float>(sample.count);
    const Response response = response_of(studio, sample, seen[k]);
    pixel.response.flat += share * response.flat;
    pixel.response.by_key += share * response.by_key;
    pixel.response.by_sky += share * response.by_sky;
    if (light.has_key[k]) pixel.key.add(light.reached[k].key, share);
    if (light.has_sky[k]) pixel.sky.add(light.reached[k].sky, share);
    if (seen[k].what == Seen::What::backdrop) continue;
    pixel.position += share * seen[k].spot.position;
    pixel.normal += share * seen[k].spot.normal;
  }
}

/// The samples of a tile, pixel by pixel, in bundles that are the same for every run.
void trace_tile(const Studio& studio, const Tracer& tracer, const tbb::blocked_range2d<int>& tile, int count,
                Negative& negative) {
  Samples samples;
  const auto flush = [&] {
    if (samples.count > 0) add_samples(studio, tracer, samples, negative);
    samples.count = 0;
  };
  for (int y = tile.rows().begin(); y < tile.rows().end(); ++y) {
    for (int x = tile.cols().begin(); x < tile.cols().end(); ++x) {
      for (int s = 0; s < count; ++s) {
        samples.lanes[samples.count++] = {static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), s,
                                          count};
        if (samples.count == kLanes) flush();
      }
    }
  }
  flush();
}

}  // namespace

float ground_distance(const Light& light, const Ray& ray) {
  const float above = ray.origin.dot(light.up) - light.floor, sinking = -ray.direction.dot(light.up);
  return above > 0 && sinking > 0 ? above / sinking : -1;
}

Picture trace_picture(const Studio& studio, const Tracer& tracer, int samples) {
  Negative negative(studio.view.width, studio.view.height);
  const int rows = (negative.height + kTile - 1) / kTile, columns = (negative.width + kTile - 1) / kTile;
  tbb::parallel_for(tbb::blocked_range2d<int>(0, rows, 1, 0, columns, 1), [&](const auto& tiles) {
    for (int row = tiles.rows().begin(); row < tiles.rows().end(); ++row) {
      for (int column = tiles.cols().begin(); column < tiles.cols().end(); ++column) {
        const tbb::blocked_range2d<int> tile(row * kTile, std::min((row + 1) * kTile, negative.height),
                                             column * kTile, std::min((column + 1) * kTile, negative.width));
        trace_tile(studio, tracer, tile, samples, negative);
      }
    }
  });
  return develop(negative, samples);
}

}  // namespace flexkey
