#pragma once

#include <filesystem>

namespace flexkey::testing {

/// Two files of one clip, of which the first is split: they show the same triangles, at rest to the bit and
/// at every frame to the tolerance (file units); and where a place at rest has vertices of one normal with
/// and without targets, they lie there together at every frame, to the bit, and have one normal. There is
/// such a place.
void expect_same_but_split(const std::filesystem::path& split, const std::filesystem::path& whole, int frames,
                           double tolerance);

}  // namespace flexkey::testing
