#pragma once

#include <Eigen/Core>

namespace flexkey {

/// Red, green and blue in linear light, 0..1.
using Rgb = Eigen::Vector3f;

/// sRGB components, 0..1, in linear light (IEC 61966-2-1).
Rgb from_srgb(const Rgb& srgb);

/// A colour from sRGB values 0..255, as designers and CSS write it.
Rgb colour_from_srgb(int red, int green, int blue);

/// The colour map viridis of matplotlib (van der Walt and Smith), at a share 0..1; clamped outside.
Rgb viridis(float share);

/// λ as a colour: blue where the surface is smooth (0), clay in between, brick red where it is rigid (1).
Rgb lambda_colour(float lambda);

}  // namespace flexkey
