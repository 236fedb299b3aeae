#pragma once

namespace flexkey {

/// A colour in linear light.
struct Colour {
  float red = 0, green = 0, blue = 0;
};

}  // namespace flexkey
