#pragma once

#include <vector>

#include "flexkey/preview/picture.h"

namespace flexkey {

/// One moment of a clip.
struct Moment {
  int frame = 0;
  double time = 0;    // seconds
  double lambda = 0;  // 0 smooth .. 1 rigid
};

/// How much of a picture's lower edge the band takes, pixels: about 7 % of its height.
int overlay_height(int picture_height);

/// Lays a light band along the picture's lower edge: on the left the time, frame and λ of now, beside them
/// the curve of λ over the clip (moments in order, not empty), dark up to now.
void draw_overlay(Picture& picture, const std::vector<Moment>& clip, const Moment& now);

}  // namespace flexkey
