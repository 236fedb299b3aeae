#include <fmt/format.h>

#include "results.h"
#include "statistics.h"

namespace flexkey::bench {

Table preview_table(const PreviewResult& result) {
  const StencilTimes& stencils = result.stencils;
  const FrameTimes& frame = result.frame;
  Table table{.title = "Previews, CPU time of one thread", .header = {"what", "takes", "against", "ratio"}};
  table.rows.push_back({fmt::format("stencils, {} control vertices to {}", stencils.control_vertices,
                                    stencils.refined_vertices),
                        seconds(median(stencils.stencils)),
                        fmt::format("PrimvarRefiner, {}", seconds(median(stencils.refining)).text),
                        ratio(stencil_ratio(stencils))});
  table.rows.push_back(
      {fmt::format("subdivision, normals and tree, {} triangles", frame.triangles),
       seconds(median(frame.geometry)),
       fmt::format("a final frame of 960 x 540, 8 samples, {}", seconds(median(frame.whole)).text),
       percent(geometry_share(frame))});
  table.rows.push_back({"peak memory of flexkey render, 240 frames of the nose",
                        megabytes(result.memory.of_240),
                        fmt::format("24 frames, {}", megabytes(result.memory.of_24).text),
                        ratio(result.memory.of_240 / result.memory.of_24)});
  return table;
}

double stencil_ratio(const StencilTimes& times) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < times.stencils.size(); ++k)
    ratios.push_back(times.stencils[k] / times.refining[k]);
  return median(ratios);
}

double geometry_share(const FrameTimes& times) {
  std::vector<double> shares;
  for (std::size_t k = 0; k < times.whole.size(); ++k) shares.push_back(times.geometry[k] / times.whole[k]);
  return median(shares);
}

}  // namespace flexkey::bench
