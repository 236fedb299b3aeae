#include "flexkey/cache/coordinates.h"

#include <fmt/format.h>

#include <string_view>

#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

[[noreturn]] void refuse(const SolvedFrame& frame, Eigen::Index vertex, std::string_view what,
                         const std::filesystem::path& path) {
  const auto& p = frame.positions.row(vertex);
  throw OutputError(
      fmt::format("cannot write '{}': vertex {} of frame {} is at ({}, {}, {}), which is not {}",
                  path.string(), vertex, frame.report.frame, p[0], p[1], p[2], what));
}

}  // namespace

FloatPositions float_positions(const SolvedFrame& frame, const std::filesystem::path& path) {
  FloatPositions positions = frame.positions.cast<float>();
  for (Eigen::Index v = 0; v < positions.rows(); ++v)
    if (!positions.row(v).allFinite()) refuse(frame, v, "a finite float", path);
  return positions;
}

void require_finite(const SolvedFrame& frame, const std::filesystem::path& path) {
  for (Eigen::Index v = 0; v < frame.positions.rows(); ++v)
    if (!frame.positions.row(v).allFinite()) refuse(frame, v, "finite", path);
}

}  // namespace flexkey
