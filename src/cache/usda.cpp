#include "flexkey/cache/usda.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "flexkey/cache/coordinates.h"
#include "flexkey/mesh/output_file.h"

namespace flexkey {
namespace {

/// The shot's name as a prim's: ASCII letters, digits and underscores, no digit first.
std::string prim_name(std::string name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::replace_if(
      name.begin(), name.end(), [&](char c) { return !is_letter(c) && !is_digit(c); }, '_');
  return name.empty() || is_digit(name.front()) ? fmt::format("_{}", name) : name;
}

/// "(x, y, z)"
template <class Row>
void append_tuple(std::string& text, const Row& row) {
  text += '(';
  for (Eigen::Index k = 0; k < row.size(); ++k)
    fmt::format_to(std::back_inserter(text), "{}{}", k == 0 ? "" : ", ", row[k]);
  text += ')';
}

/// "[(x, y, z), …]"
template <class Rows>
std::string tuples(const Rows& rows) {
  std::string text = "[";
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    if (k > 0) text += ", ";
    append_tuple(text, rows.row(k));
  }
  return text += ']';
}

std::vector<int> corner_counts(const Mesh& mesh) {
  std::vector<int> counts;
  for (int f = 0; f < mesh.face_count(); ++f) counts.push_back(static_cast<int>(mesh.face(f).size()));
  return counts;
}

/// Texture coordinates, an index a corner; corners that have none go to a further one at the origin.
std::string texcoords_text(const Mesh& mesh) {
  if (mesh.corner_texcoord.empty()) return {};
  Eigen::Matrix<float, Eigen::Dynamic, 2, Eigen::RowMajor> texcoords = mesh.texcoords.cast<float>();
  const auto none = static_cast<int>(texcoords.rows());
  std::vector<int> indices = mesh.corner_texcoord;
  if (std::find(indices.begin(), indices.end(), -1) != indices.end()) {
    std::replace(indices.begin(), indices.end(), -1, none);
    texcoords.conservativeResize(none + 1, Eigen::NoChange);
    texcoords.row(none).setZero();
  }
  return fmt::format(
      "        texCoord2f[] primvars:st = {} (\n"
      "            interpolation = \"faceVarying\"\n"
      "        )\n"
      "        int[] primvars:st:indices = [{}]\n",
      tuples(texcoords), fmt::join(indices, ", "));
}

/// All before the first sample.
std::string opening_text(const CacheShape& shape) {
  const std::string name = prim_name(shape.name);
  std::string text = fmt::format(
      "#usda 1.0\n"
      "(\n"
      "    defaultPrim = \"{}\"\n"
      "    endTimeCode = {}\n"
      "    framesPerSecond = {}\n"
      "    metersPerUnit = 1\n"
      "    startTimeCode = {}\n"
      "    timeCodesPerSecond = {}\n"
      "    upAxis = \"{}\"\n"
      ")\n\n"
      "def Xform \"{}\"\n"
      "{{\n"
      "    def Mesh \"mesh\"\n"
      "    {{\n",
      name, shape.frames.back(), shape.fps, shape.frames.front(), shape.fps,
      shape.up == CacheShape::Up::z ? 'Z' : 'Y', name);
  text += fmt::format("        int[] faceVertexCounts = [{}]\n", fmt::join(corner_counts(shape.mesh), ", "));
  text += fmt::format("        int[] faceVertexIndices = [{}]\n", fmt::join(shape.mesh.corners, ", "));
  text += "        uniform token subdivisionScheme = \"none\"\n";
  text += texcoords_text(shape.mesh);
  text += fmt::format("        point3f[] points = {}\n",
                      tuples(FloatPositions(shape.mesh.positions.cast<float>())));
  return text += "        point3f[] points.timeSamples = {\n";
}

std::string sample_text(int frame, std::string_view value) {
  return fmt::format("            {}: {},\n", frame, value);
}

/// The file on its way. The boxes around the frames have a block of their own, which comes after the last.
struct UsdaFile {
  explicit UsdaFile(const std::filesystem::path& path) : file(path) {}
  OutputFile file;
  std::string extents = "        float3[] extent.timeSamples = {\n";
};

std::string extent_of(const FloatPositions& positions) {
  Eigen::Matrix<float, 2, 3, Eigen::RowMajor> extent;
  extent << positions.colwise().minCoeff(), positions.colwise().maxCoeff();
  return tuples(extent);
}

}  // namespace

FrameSink usda_sink(const std::filesystem::path& path, const CacheShape& shape) {
  const auto usda = std::make_shared<UsdaFile>(path);
  usda->file.write(opening_text(shape));
  return {.add =
              [=](const SolvedFrame& frame) {
                const FloatPositions positions = float_positions(frame, path);
                usda->extents += sample_text(frame.report.frame, extent_of(positions));
                usda->file.write(sample_text(frame.report.frame, tuples(positions)));
              },
          .finish =
              [=] {
                usda->file.write("        }\n");
                usda->file.write(usda->extents);
                usda->file.write("        }\n    }\n}\n");
                usda->file.commit();
                return usda->file.bytes_written();
              }};
}

}  // namespace flexkey
