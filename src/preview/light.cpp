#include "flexkey/preview/light.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "flexkey/preview/bayer.h"

namespace flexkey {
namespace {

// Irradiances are over pi: 1 shows a white matte surface as white.
const Rgb kKey(0.90f, 0.845f, 0.77f);
const Rgb kSky(0.375f, 0.395f, 0.425f);
const Rgb kBounce(0.165f, 0.152f, 0.14f);
const Rgb kFill(0.13f, 0.14f, 0.155f);
const Rgb kRim(0.10f, 0.105f, 0.11f);
constexpr float kKeySize = 0.22f;  // radius of the key light at a distance of one
constexpr float kGloss = 0.045f;   // of clay that has been smoothed by hand

/// A colour of the backdrop, and how far the next of 8-bit sRGB is from it.
struct Paper {
  Rgb colour, step;

  explicit Paper(const Rgb& srgb)
      : colour(from_srgb(srgb)), step(from_srgb(srgb + Rgb::Constant(1.0f / 255)) - colour) {}
};

float smoothstep(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

}  // namespace

Light::Light(const View& view, const Eigen::Vector3f& vertical, float floor_height)
    : up(vertical), floor(floor_height) {
  const Eigen::Vector3f toward = view.right.cross(up);  // level, from the scene to the viewer
  key = (-0.62f * view.right + 1.0f * up + 0.55f * toward).normalized();
  fill = (0.85f * view.right + 0.25f * up + 0.5f * toward).normalized();
  key_side = kKeySize * key.cross(up).normalized();
  key_front = kKeySize * key.cross(key_side).normalized();
}

Response spot_response(const Light& light, const Spot& spot) {
  Response response;
  if (!spot.is_lit) {
    response.flat = spot.colour;
    return response;
  }
  const Eigen::Vector3f& n = spot.normal;
  const float facing = std::max(n.dot(light.key), 0.0f);
  const float upward = 0.5f + 0.5f * n.dot(light.up);
  const float wrapped = std::max(0.3f + 0.7f * n.dot(light.fill), 0.0f);
  const Eigen::Vector3f half = (light.key + spot.view).normalized();
  const float gloss = kGloss * std::pow(std::max(n.dot(half), 0.0f), 24.0f);
  const float edge = std::pow(1 - std::clamp(n.dot(spot.view), 0.0f, 1.0f), 3.0f);
  const Rgb sky = upward * kSky + (1 - upward) * kBounce + wrapped * kFill;
  response.by_key = (facing * spot.colour + Rgb::Constant(gloss)).cwiseProduct(kKey);
  response.by_sky = spot.colour.cwiseProduct(sky) + edge * upward * kRim;
  return response;
}

Response ground_response(const Rgb& behind, float distance) {
  const float strength = 0.78f * (1 - smoothstep(0.6f, kGroundEdge, distance));
  return {(1 - strength) * behind, 0.5f * strength * behind, 0.5f * strength * behind};
}

Rgb backdrop(const View& view, int x, int y) {
  static const Paper middle({0.940f, 0.934f, 0.924f}), corner({0.790f, 0.793f, 0.798f});
  const float across = (static_cast<float>(x) + 0.5f) / static_cast<float>(view.width);
  const float down = (static_cast<float>(y) + 0.5f) / static_cast<float>(view.height);
  const float distance = std::hypot((across - 0.5f) * 1.15f, (down - 0.52f) * 1.05f);
  const float share = smoothstep(0.05f, 0.95f, distance);
  const float strewn = (static_cast<float>(bayer(x, y)) + 0.5f) / 64 - 0.5f;
  return (1 - share) * (middle.colour + strewn * middle.step) +
         share * (corner.colour + strewn * corner.step);
}

}  // namespace flexkey
