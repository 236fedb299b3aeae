#pragma once

#include <filesystem>
#include <vector>

#include "flexkey/cache/frame_sink.h"

namespace flexkey {

/// An OBJ a frame with the mesh's polygons, texture coordinates, groups (`g`) and material names (`usemtl`),
/// vertices and faces in the mesh file's order, coordinates to the last bit. `libraries`: the mesh's material
/// libraries, which each file names from where it lies.
FrameSink obj_sequence_sink(const FramePath& path_of, const CacheShape& shape,
                            const std::vector<std::filesystem::path>& libraries = {});

}  // namespace flexkey
