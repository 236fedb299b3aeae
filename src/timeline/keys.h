#pragma once

#include <span>
#include <string_view>

namespace flexkey {

/// Whether this version does what a key asks.
enum class Built {
  yes,
  ignored,  // known, not built yet: one warning, and the shot runs on without it
  refused,  // known, not built yet, and the shot would mean another thing without it: an error
};

/// One key of a mapping of the format. The readers and the schema come from the same tables.
struct KeySpec {
  std::string_view name;
  std::string_view about;  // one line, with units
  Built built = Built::yes;
};

/// A mapping of the format whose keys are fixed.
struct MappingSpec {
  std::string_view example;
  std::span<const KeySpec> keys;
};

extern const MappingSpec shot_keys;
extern const MappingSpec mesh_keys;
extern const MappingSpec handle_keys;
extern const MappingSpec selection_keys;
extern const MappingSpec sphere_keys;
extern const MappingSpec box_keys;
extern const MappingSpec plane_keys;
extern const MappingSpec geodesic_keys;
extern const MappingSpec track_keys;  // move, to, scale, curve
extern const MappingSpec rotate_keys;
extern const MappingSpec follow_keys;
extern const MappingSpec motion_keys;
extern const MappingSpec pose_keys;
extern const MappingSpec posed_keys;  // a handle in a pose
extern const MappingSpec wave_keys;
extern const MappingSpec noise_keys;
extern const MappingSpec mirror_keys;
extern const MappingSpec turn_keys;  // the value of a rotate key with an axis of its own
extern const MappingSpec key_keys;   // one key of a track, in the list form
extern const MappingSpec curve_keys;
extern const MappingSpec lambda_keys;
extern const MappingSpec region_keys;  // an item of lambda.regions
extern const MappingSpec attach_keys;  // an item of attach
extern const MappingSpec solver_keys;
extern const MappingSpec output_keys;
extern const MappingSpec gltf_keys;
extern const MappingSpec file_keys;  // an entry of cache, frames or usd; html
extern const MappingSpec animation_keys;
extern const MappingSpec preview_keys;
extern const MappingSpec camera_keys;  // of a preview
extern const MappingSpec gif_keys;
extern const MappingSpec sheet_keys;

}  // namespace flexkey
