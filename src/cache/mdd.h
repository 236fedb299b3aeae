#pragma once

#include <filesystem>

#include "flexkey/cache/frame_sink.h"

namespace flexkey {

/// LightWave's MDD, as Blender's Mesh Cache modifier reads it, big-endian: int32 #frames, int32 #V, a float a
/// frame, its time in seconds (k / fps), then for each frame #V x 3 floats. Vertices in the mesh file's
/// order, in the mesh's own axes and units; the modifier's axes are those of pc2.h.
FrameSink mdd_sink(const std::filesystem::path& path, const CacheShape& shape);

}  // namespace flexkey
