#pragma once

#include <filesystem>

#include "flexkey/cache/frame_sink.h"

namespace flexkey {

/// USD as text: one Mesh whose points have a time sample a frame, which Blender and Unreal read as a geometry
/// cache. Time codes are frame numbers, `timeCodesPerSecond` is fps; the mesh's own coordinates, `upAxis` Y,
/// `metersPerUnit` 1; polygons as they are, not subdivided, the rest positions as the points' default value,
/// texture coordinates as `primvars:st`.
FrameSink usda_sink(const std::filesystem::path& path, const CacheShape& shape);

}  // namespace flexkey
