#include <fmt/format.h>

#include "results.h"

namespace flexkey::bench {
namespace {

Cell whole(int number) {
  return {fmt::format("{}", number), static_cast<double>(number)};
}

Cell megabytes(double bytes) {
  return {fmt::format("{:.2f} MB", bytes / 1e6), bytes};
}

std::vector<Cell> row_of(const GltfResult& result, const char* profile, const Written& written) {
  const GltfReport& report = written.report;
  const auto bytes = static_cast<double>(report.bytes);
  return {result.name,
          whole(result.frames),
          profile,
          whole(report.targets),
          megabytes(bytes),
          ratio(result.dense / bytes),
          share_of_diagonal(report.error),
          Cell(fmt::format("{:.2f}", report.kg_error), report.kg_error),
          Cell(fmt::format("{:.2f}°", report.normal_error_mean), report.normal_error_mean),
          seconds(written.seconds)};
}

std::vector<Cell> row_of(const GltfResult& result, const Packed& packed) {
  const GltfReport& web = packed.web.report;
  const auto bytes = static_cast<double>(web.bytes);
  return {result.name,
          whole(result.frames),
          packed.options,
          megabytes(packed.bytes),
          share_of_diagonal(packed.error),
          whole(web.targets),
          megabytes(bytes),
          share_of_diagonal(web.error),
          ratio(packed.bytes / bytes)};
}

}  // namespace

Table gltf_table(const std::vector<GltfResult>& results) {
  Table table{.title = "glTF: files at a tolerance of 0.1 % of the diagonal",
              .header = {"clip", "frames", "profile", "targets", "size", "dense / size", "largest error",
                         "KG error, %", "normals off by", "export, CPU"}};
  for (const GltfResult& result : results) {
    table.rows.push_back(row_of(result, "compat", result.compat));
    table.rows.push_back(row_of(result, "web", result.web));
  }
  table.note =
      "Dense is one target a frame, positions and normals in floats, nothing sparse. Errors are of the file "
      "read back, at every frame.";
  return table;
}

Table gltfpack_table(const std::vector<GltfResult>& results) {
  Table table{
      .title = "glTF: gltfpack on the file of one target a frame, and web with that error as its tolerance",
      .header = {"clip", "frames", "gltfpack", "size", "largest error", "web: targets", "size",
                 "largest error", "gltfpack / web"}};
  for (const GltfResult& result : results)
    for (const Packed& packed : result.packed) table.rows.push_back(row_of(result, packed));
  table.note =
      "Errors are of the files read back, at every frame of the clip. -cc alone plays frames of its own at "
      "30 Hz, "
      "-af 0 keeps the clip's, and -vp is the fewest bits that stay within 0.1 % of the diagonal.";
  return table;
}

}  // namespace flexkey::bench
