#pragma once

namespace flexkey {

/// Bayer's order of 8 x 8 pixels, 0..63: what lies between two values is strewn by it evenly, the same at a
/// pixel in every frame.
int bayer(int x, int y);

}  // namespace flexkey
