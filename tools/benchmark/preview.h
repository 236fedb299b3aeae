#pragma once

#include <filesystem>
#include <vector>

namespace flexkey::bench {

/// Seconds of CPU on one thread, an entry a round.
struct StencilTimes {
  int control_vertices = 0, refined_vertices = 0;
  std::vector<double> stencils;  // applying them
  std::vector<double> refining;  // OpenSubdiv's PrimvarRefiner from level to level
};

struct FrameTimes {
  int triangles = 0;
  std::vector<double> whole;     // a final picture
  std::vector<double> geometry;  // of it: subdivision, normals and the tree
};

/// The most memory that `flexkey render` has resident with so many frames of the nose, bytes.
struct RenderMemory {
  double of_24 = 0, of_240 = 0;
};

struct PreviewResult {
  RenderMemory memory;
  StencilTimes stencils;
  FrameTimes frame;
};

/// Before the caller grows, whose memory would count.
RenderMemory measure_render_memory(const std::filesystem::path& timelines);
StencilTimes time_stencils();
FrameTimes time_frames();

}  // namespace flexkey::bench
