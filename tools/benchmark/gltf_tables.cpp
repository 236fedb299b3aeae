#include <fmt/format.h>

#include "results.h"

namespace flexkey::bench {
namespace {

Cell times_smaller(double dense, double bytes) {
  return bytes > 0 ? ratio(dense / bytes) : Cell("—");
}

Cell whole(int number) {
  return {fmt::format("{}", number), static_cast<double>(number)};
}

std::vector<Cell> row_of(const GltfResult& result, const char* profile, const Written& written) {
  const GltfReport& report = written.report;
  const auto bytes = static_cast<double>(report.bytes);
  return {result.name,
          whole(result.frames),
          profile,
          whole(report.targets),
          Cell(fmt::format("{:.2f} MB", bytes / 1e6), bytes),
          times_smaller(result.dense, bytes),
          result.gltfpack > 0 ? ratio(result.gltfpack / bytes) : Cell("—"),
          share_of_diagonal(report.error),
          Cell(fmt::format("{:.2f}", report.kg_error), report.kg_error),
          Cell(fmt::format("{:.2f}°", report.normal_error_mean), report.normal_error_mean),
          seconds(written.seconds)};
}

}  // namespace

Table gltf_table(const std::vector<GltfResult>& results) {
  Table table{
      .title = "glTF: files at a tolerance of 0.1 % of the diagonal",
      .header = {"clip", "frames", "profile", "targets", "size", "dense / size", "gltfpack -cc / size",
                 "largest error", "KG error, %", "normals off by", "export, CPU"}};
  for (const GltfResult& result : results) {
    table.rows.push_back(row_of(result, "compat", result.compat));
    table.rows.push_back(row_of(result, "web", result.web));
  }
  table.note =
      "Dense is one target a frame, positions and normals in floats, nothing sparse; gltfpack -cc reads the "
      "file "
      "of one target a frame. Errors are of the file read back, at every frame.";
  return table;
}

}  // namespace flexkey::bench
