#pragma once

#include "flexkey/cache/frame_sink.h"

namespace flexkey {

/// A NumPy archive (.npz, not compressed) a frame, for `numpy.load`:
/// | array | type, shape | |
/// |---|---|---|
/// | `positions` | float64, V x 3 | as solved, vertices in the mesh file's order |
/// | `faces` | int32, F x n | where all faces have n corners; else the two below |
/// | `face_offsets`, `corners` | int32, F + 1 and C | face f has corners[face_offsets[f]:face_offsets[f + 1]]
/// | | `frame`, `time`, `lambda` | int32, float64, float64 | number, seconds, λ | | `handle_names` | text, H
/// | | | `handle_matrices` | float64, H x 4 x 4 | rest to frame, M[h] @ [x, y, z, 1] |
FrameSink npz_sequence_sink(const FramePath& path_of, const CacheShape& shape);

}  // namespace flexkey
