#include "flexkey/cache/pc2.h"

#include <fmt/format.h>

#include <memory>
#include <string>

#include "flexkey/cache/byte_order.h"
#include "flexkey/cache/coordinates.h"
#include "flexkey/mesh/error.h"
#include "flexkey/mesh/output_file.h"

namespace flexkey {
namespace {

std::string header_of(const CacheShape& shape) {
  std::string header("POINTCACHE2\0", 12);
  append_little_endian(header, 1);
  append_little_endian(header, bits_of(shape.mesh.vertex_count()));
  append_little_endian(header, bits_of(static_cast<float>(shape.frames.front())));
  append_little_endian(header, bits_of(static_cast<float>(even_step(shape.frames))));
  append_little_endian(header, bits_of(static_cast<int>(shape.frames.size())));
  return header;
}

std::string sample_of(const FloatPositions& positions) {
  std::string sample;
  sample.reserve(static_cast<std::size_t>(positions.size()) * sizeof(float));
  for (const float coordinate : positions.reshaped<Eigen::RowMajor>())
    append_little_endian(sample, bits_of(coordinate));
  return sample;
}

}  // namespace

int even_step(const std::vector<int>& frames) {
  if (frames.size() < 2) return 1;
  const int step = frames[1] - frames[0];
  for (std::size_t k = 2; k < frames.size(); ++k)
    if (frames[k] - frames[k - 1] != step) return 0;
  return step;
}

FrameSink pc2_sink(const std::filesystem::path& path, const CacheShape& shape) {
  if (even_step(shape.frames) == 0)
    throw OutputError(fmt::format(
        "cannot write '{}': a PC2 has one distance between its samples, and the frames differ in theirs",
        path.string()));
  const auto file = std::make_shared<OutputFile>(path);
  file->write(header_of(shape));
  return {.add = [=](const SolvedFrame& frame) { file->write(sample_of(float_positions(frame, path))); },
          .finish =
              [=] {
                file->commit();
                return file->bytes_written();
              }};
}

}  // namespace flexkey
