#pragma once

#include <filesystem>
#include <vector>

#include "flexkey/cache/frame_sink.h"

namespace flexkey {

/// How many frames lie between neighbours, 1 for a single frame; 0 where the distances differ, which a PC2
/// cannot say.
int even_step(const std::vector<int>& frames);

/// Point Cache 2, as Blender's Mesh Cache modifier and 3ds Max read it, little-endian:
/// char[12] "POINTCACHE2\0", int32 version 1, int32 #V, float start (the number of the first frame), float
/// sampling (frames a sample), int32 #samples; then for each sample #V x 3 floats. Vertices in the mesh
/// file's order, in the mesh's own axes and units. Blender's OBJ importer turns the object and not its mesh,
/// so the modifier keeps its default axes, forward Y and up Z; its time mode is Frame (under Time,
/// Blender 3.4 divides by the frame rate twice). Throws OutputError where the frames are not evenly spaced.
FrameSink pc2_sink(const std::filesystem::path& path, const CacheShape& shape);

}  // namespace flexkey
