#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "flexkey/deform/deformer.h"

namespace flexkey::bench {

/// A mesh, what is held, and where that goes frame by frame: one scene of the bench.
struct Motion {
  std::string name;
  Mesh mesh;
  Constraints constraints;
  std::vector<Targets> frames;  // the first is one step away from rest
};

/// The 4:1 bar of timelines/meshes/bar.obj, 1,802 vertices, held at one end and moved at the other in 12
/// frames: twisted by 90°, bent into an arc of 90°, both at once, stretched by 30 %, moved sideways by half
/// its length.
std::vector<Motion> bar_motions(const std::filesystem::path& bar);

/// The blob (see make_blob) held by the lowest 5 % of its vertices, its highest 1 % bent by 90° and stretched
/// by 30 % over 60 frames.
Motion blob_motion(int size);

/// The same blob bent and stretched by so much and back in this many frames, with an ease in and out; the
/// first frame is at rest.
Motion blob_there_and_back(int size, int frames);

/// The frames of a timeline's shot in which its handles move. Throws Error if it cannot be read, or turns
/// faster than one solve a frame may follow.
Motion shot_motion(const std::filesystem::path& timeline);

}  // namespace flexkey::bench
