#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// How much flexkey takes of what may be hostile: every input is refused with a message before it takes more
/// than these. SECURITY.md says what follows from them.
namespace flexkey::limits {

// A timeline.
inline constexpr std::size_t timeline_bytes = 4 << 20;
inline constexpr std::size_t timeline_values = 100'000;  // with its aliases and variables put in
inline constexpr int timeline_depth = 64;                // of values within values, likewise
inline constexpr int frames = 100'000;
inline constexpr int frames_a_second = 1000;

// A mesh, and any other file that a timeline names.
inline constexpr std::uintmax_t file_bytes = std::uintmax_t{4} << 30;
inline constexpr int vertices = 20'000'000;
inline constexpr int faces = 40'000'000;
inline constexpr int corners = 120'000'000;
inline constexpr int group_faces = 120'000'000;  // in all groups together: a face may be in many
inline constexpr double coordinate = 1e30;       // its square and a sum of many are still numbers
inline constexpr int json_depth = 100;           // of a glTF

// A saved solve, which flexkey itself wrote: some 400 bytes a vertex.
inline constexpr std::uintmax_t checkpoint_bytes = std::uintmax_t{64} << 30;

// Pictures.
inline constexpr int picture_side = 16'384;                  // what picture formats and viewers take
inline constexpr std::int64_t drawn_pixels = 36'000'000;     // 3 GB while a picture is made; 7680 x 4320 fits
inline constexpr std::int64_t picture_pixels = 100'000'000;  // of a texture or a sheet
inline constexpr std::uintmax_t texture_bytes = 512u << 20;

/// How many of each kind a mesh may have.
struct MeshSize {
  std::size_t vertices = limits::vertices, faces = limits::faces, corners = limits::corners,
              group_faces = limits::group_faces;
};

/// "more than 20000000 vertices"; what: "vertices".
std::string more_than(std::size_t most, std::string_view what);

}  // namespace flexkey::limits
