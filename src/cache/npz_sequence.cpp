#include "flexkey/cache/npz_sequence.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "flexkey/cache/coordinates.h"
#include "flexkey/cache/npy.h"
#include "flexkey/cache/zip_archive.h"

namespace flexkey {
namespace {

/// An array and the name of its file in the archive.
struct NamedArray {
  std::string name;
  std::string bytes;
};

/// How many corners every face has; 0 where they differ.
std::size_t corners_of_every_face(const Mesh& mesh) {
  const std::size_t corners = mesh.face_count() == 0 ? 0 : mesh.face(0).size();
  for (int f = 1; f < mesh.face_count(); ++f)
    if (mesh.face(f).size() != corners) return 0;
  return corners;
}

/// The arrays that are the same on every frame.
std::vector<NamedArray> common_arrays(const CacheShape& shape) {
  const Mesh& mesh = shape.mesh;
  std::vector<NamedArray> arrays;
  if (const std::size_t corners = corners_of_every_face(mesh); corners > 0) {
    const auto faces = static_cast<std::size_t>(mesh.face_count());
    arrays.push_back({"faces.npy", npy_bytes(mesh.corners, {faces, corners})});
  } else {
    arrays.push_back({"face_offsets.npy", npy_bytes(mesh.face_offsets, {mesh.face_offsets.size()})});
    arrays.push_back({"corners.npy", npy_bytes(mesh.corners, {mesh.corners.size()})});
  }
  arrays.push_back({"handle_names.npy", npy_bytes(shape.handles)});
  return arrays;
}

std::string scalar(double value) {
  return npy_bytes(std::span(&value, 1), {});
}

std::vector<NamedArray> frame_arrays(const SolvedFrame& frame, double fps) {
  const Positions& positions = frame.positions;
  std::vector<double> matrices;
  for (const Eigen::Matrix4d& matrix : frame.handles) {
    const auto rows = matrix.reshaped<Eigen::RowMajor>();
    matrices.insert(matrices.end(), rows.begin(), rows.end());
  }
  return {{"positions.npy", npy_bytes(std::span(positions.data(), static_cast<std::size_t>(positions.size())),
                                      {static_cast<std::size_t>(positions.rows()), 3})},
          {"frame.npy", npy_bytes(std::span(&frame.report.frame, 1), {})},
          {"time.npy", scalar(frame.report.frame / fps)},
          {"lambda.npy", scalar(frame.report.lambda)},
          {"handle_matrices.npy", npy_bytes(matrices, {frame.handles.size(), 4, 4})}};
}

}  // namespace

FrameSink npz_sequence_sink(const FramePath& path_of, const CacheShape& shape) {
  const auto common = std::make_shared<const std::vector<NamedArray>>(common_arrays(shape));
  const auto bytes = std::make_shared<std::uintmax_t>(0);
  const double fps = shape.fps;
  return {.add =
              [=](const SolvedFrame& frame) {
                const std::filesystem::path path = path_of(frame.report.frame);
                require_finite(frame, path);
                const std::vector<NamedArray> own = frame_arrays(frame, fps);
                std::vector<ZipEntry> entries;
                for (const std::vector<NamedArray>* arrays : {&own, common.get()})
                  for (const NamedArray& array : *arrays) entries.push_back({array.name, array.bytes});
                *bytes += write_zip(path, entries);
              },
          .finish = [=] { return *bytes; }};
}

}  // namespace flexkey
