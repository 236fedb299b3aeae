#include "flexkey/gltf/compatibility.h"

#include <fmt/format.h>

namespace flexkey {
namespace {

// WebGL 2 guarantees arrays of 256 texture layers, and a target takes one; filament's own limit is the same.
constexpr int kLayers = 256;

ClientNote by_layers(const char* client, int targets) {
  if (targets <= kLayers) return {client, true, ""};
  return {client, false, fmt::format("{} targets, and {} are sure to play", targets, kLayers)};
}

}  // namespace

std::vector<ClientNote> client_notes(int targets, bool has_meshopt) {
  std::vector<ClientNote> notes = {by_layers("three.js", targets), by_layers("Babylon.js", targets),
                                   by_layers("filament", targets)};
  if (has_meshopt && notes[0].plays) notes[0].why = "with its MeshoptDecoder set";
  for (const char* client : {"Blender", "Godot"}) {
    notes.push_back({client, !has_meshopt, has_meshopt ? "reads no EXT_meshopt_compression" : ""});
  }
  return notes;
}

}  // namespace flexkey
