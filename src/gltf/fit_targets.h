#pragma once

#include <functional>
#include <vector>

#include "flexkey/gltf/basis.h"

namespace flexkey {

/// An attribute of frame k, such as its normals, #V x 3.
using FrameAttribute = std::function<Positions(std::size_t frame)>;

/// The deltas of another attribute that the basis's weights play best: least squares over the frames,
/// #targets of #V x 3. Asks for each frame once, in order; the smallest deltas where several are best. rest:
/// the attribute at rest, #V x 3, to which clients add the deltas after rounding it to floats. still: rows
/// that never differ from rest by more get exact zeros, in the attribute's units.
std::vector<FloatRows> fit_targets(const Basis& basis, std::span<const int> numbers, const Positions& rest,
                                   const FrameAttribute& attribute, double still);

}  // namespace flexkey
