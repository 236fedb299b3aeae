#pragma once

#include "flexkey/preview/colour.h"
#include "flexkey/preview/view.h"

namespace flexkey {

/// A studio that turns with the camera: a large warm key light above its left shoulder, a cool sky, bounce
/// from the floor and a faint rim. Lengths in unit space.
struct Light {
  Eigen::Vector3f key;                  // towards the middle of the key light
  Eigen::Vector3f key_side, key_front;  // half axes of its disc, at a distance of one
  Eigen::Vector3f fill;                 // towards the soft light from the right
  Eigen::Vector3f up;
  float floor = 0;  // height of the ground

  Light(const View& view, const Eigen::Vector3f& vertical, float floor_height);
};

/// What light meets at a point of a surface.
struct Spot {
  Eigen::Vector3f position, normal;  // the normal is smooth and faces the viewer
  Eigen::Vector3f face;              // the triangle's own normal, on the same side
  Eigen::Vector3f view;              // towards the viewer
  Rgb colour;                        // diffuse reflectance, or what is seen where no light is asked for
  bool is_lit = true;
};

/// The share of the key light and of the sky that reach a spot, 0..1.
struct Reached {
  float key = 1, sky = 1;
};

/// The light that the viewer receives, by how much of each source gets through.
struct Response {
  Rgb flat = Rgb::Zero(), by_key = Rgb::Zero(), by_sky = Rgb::Zero();

  Rgb under(const Reached& reached) const { return flat + reached.key * by_key + reached.sky * by_sky; }
};

/// Of a spot of the surface or of a mark.
Response spot_response(const Light& light, const Spot& spot);

/// Of the ground in front of a backdrop of this colour: it only shows shadows, and none at kGroundEdge from
/// the middle of the clip.
inline constexpr float kGroundEdge = 2.2f;
Response ground_response(const Rgb& behind, float distance);

/// A paper roll behind everything, lighter in the middle, at a pixel. It goes up and down by less than one
/// value of an 8-bit picture from pixel to pixel, so that such a picture shows no bands.
Rgb backdrop(const View& view, int x, int y);

}  // namespace flexkey
