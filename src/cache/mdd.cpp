#include "flexkey/cache/mdd.h"

#include <memory>
#include <string>

#include "flexkey/cache/byte_order.h"
#include "flexkey/cache/coordinates.h"
#include "flexkey/mesh/output_file.h"

namespace flexkey {
namespace {

std::string header_of(const CacheShape& shape) {
  std::string header;
  append_big_endian(header, bits_of(static_cast<int>(shape.frames.size())));
  append_big_endian(header, bits_of(shape.mesh.vertex_count()));
  for (const int frame : shape.frames)
    append_big_endian(header, bits_of(static_cast<float>(frame / shape.fps)));
  return header;
}

std::string frame_bytes(const FloatPositions& positions) {
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(positions.size()) * sizeof(float));
  for (const float coordinate : positions.reshaped<Eigen::RowMajor>())
    append_big_endian(bytes, bits_of(coordinate));
  return bytes;
}

}  // namespace

FrameSink mdd_sink(const std::filesystem::path& path, const CacheShape& shape) {
  const auto file = std::make_shared<OutputFile>(path);
  file->write(header_of(shape));
  return {.add = [=](const SolvedFrame& frame) { file->write(frame_bytes(float_positions(frame, path))); },
          .finish =
              [=] {
                file->commit();
                return file->bytes_written();
              }};
}

}  // namespace flexkey
