#pragma once

#include <span>
#include <string_view>

namespace flexkey {

/// One key of a mapping of the format: the readers' keys, and what the schema says of them.
///
/// What may stand behind it is one of several forms, joined by '|', and "required" before them:
///   'word'               that word
///   number[0,1]          a number, and its range: [ and ] with its ends, ( and ) without; an end may be
///   missing whole[1,9]           a whole number, likewise {solver}             the mapping of that name;
///   {track of form}: a track of such values list(form), pair(form), triple(form)   of any, two or three of
///   them names(form)          a mapping from names to such values keys(form)           values by time,
///   {time: form} or [{at, value, ease}] text, path, time, angle, length, point, vector, axis, switch, ease,
///   curve, range, any
struct KeySpec {
  std::string_view name;
  std::string_view form;
  std::string_view about;  // one line, with units
};

/// A mapping of the format whose keys are fixed.
struct MappingSpec {
  std::string_view name;
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
extern const MappingSpec sweep_keys;  // besides them any key path
extern const MappingSpec output_keys;
extern const MappingSpec gltf_keys;
extern const MappingSpec file_keys;  // an entry of cache, frames or usd; html
extern const MappingSpec animation_keys;
extern const MappingSpec preview_keys;
extern const MappingSpec camera_keys;  // of a preview
extern const MappingSpec gif_keys;
extern const MappingSpec sheet_keys;

/// Each of them.
std::span<const MappingSpec* const> all_mappings();

}  // namespace flexkey
