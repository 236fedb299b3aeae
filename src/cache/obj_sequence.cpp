#include "flexkey/cache/obj_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <system_error>

#include "flexkey/cache/coordinates.h"
#include "flexkey/mesh/output_file.h"

namespace flexkey {
namespace {

namespace fs = std::filesystem;

/// A name that readers take for one: nothing in it ends the line or begins a comment.
std::string in_one_line(std::string name) {
  const auto ends_it = [](unsigned char c) { return c < ' ' || c == '#'; };
  std::replace_if(name.begin(), name.end(), ends_it, '_');
  return name;
}

/// A name as one word, since a `g` line names a group a word.
std::string word_of(const std::string& name) {
  std::string word = in_one_line(name);
  std::replace(word.begin(), word.end(), ' ', '_');
  return word;
}

/// The `g` line of each face; without a name where it is in no group.
std::vector<std::string> group_lines(const Mesh& mesh) {
  std::vector<std::string> lines(static_cast<std::size_t>(mesh.face_count()));
  for (const Group& group : mesh.groups)
    for (const int f : group.faces)
      lines[static_cast<std::size_t>(f)] += fmt::format(" {}", word_of(group.name));
  for (std::string& line : lines) line = fmt::format("g{}\n", line);
  return lines;
}

std::string material_line(const Mesh& mesh, int material) {
  if (material < 0) return "usemtl\n";
  return fmt::format("usemtl {}\n", in_one_line(mesh.materials[static_cast<std::size_t>(material)].name));
}

std::string face_line(const Mesh& mesh, int f) {
  std::string line = "f";
  const auto first = static_cast<std::size_t>(mesh.face_offsets[static_cast<std::size_t>(f)]);
  const auto last = static_cast<std::size_t>(mesh.face_offsets[static_cast<std::size_t>(f) + 1]);
  for (std::size_t c = first; c < last; ++c) {
    const int texcoord = mesh.corner_texcoord.empty() ? -1 : mesh.corner_texcoord[c];
    fmt::format_to(std::back_inserter(line), " {}", mesh.corners[c] + 1);
    if (texcoord >= 0) fmt::format_to(std::back_inserter(line), "/{}", texcoord + 1);
  }
  return line += '\n';
}

/// Texture coordinates, faces and what is sharp: what stands behind the vertices of every frame.
std::string connectivity_text(const Mesh& mesh) {
  std::string text;
  for (const auto& uv : mesh.texcoords.rowwise())
    fmt::format_to(std::back_inserter(text), "vt {} {}\n", uv[0], uv[1]);
  const std::vector<std::string> groups = group_lines(mesh);
  std::string group = "g\n";
  int material = -1;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto k = static_cast<std::size_t>(f);
    if (groups[k] != group) text += group = groups[k];
    if (!mesh.face_material.empty() && mesh.face_material[k] != material)
      text += material_line(mesh, material = mesh.face_material[k]);
    text += face_line(mesh, f);
  }
  const auto out = std::back_inserter(text);
  for (const Crease& crease : mesh.creases)
    fmt::format_to(out, "t crease 2/1/0 {} {} {}\n", crease.from, crease.to, crease.sharpness);
  for (const SharpVertex& sharp : mesh.sharp_vertices)
    fmt::format_to(out, "t corner 1/1/0 {} {}\n", sharp.vertex, sharp.sharpness);
  return text;
}

/// `to` as seen from a folder, or whole where there is no way from there.
fs::path seen_from(const fs::path& folder, const fs::path& to) {
  std::error_code error;
  const fs::path relative = fs::relative(to, folder.empty() ? "." : folder, error);
  return error || relative.empty() ? fs::absolute(to, error) : relative;
}

std::string frame_head(const SolvedFrame& frame, const fs::path& folder,
                       const std::vector<fs::path>& libraries) {
  std::string text = fmt::format("# frame {}, lambda {}\n", frame.report.frame, frame.report.lambda);
  for (const fs::path& library : libraries)
    text += fmt::format("mtllib {}\n", seen_from(folder, library).generic_string());
  for (const auto& p : frame.positions.rowwise())
    fmt::format_to(std::back_inserter(text), "v {} {} {}\n", p[0], p[1], p[2]);
  return text;
}

}  // namespace

FrameSink obj_sequence_sink(const FramePath& path_of, const CacheShape& shape,
                            const std::vector<fs::path>& libraries) {
  const auto connectivity = std::make_shared<const std::string>(connectivity_text(shape.mesh));
  const auto bytes = std::make_shared<std::uintmax_t>(0);
  return {.add =
              [=](const SolvedFrame& frame) {
                const fs::path path = path_of(frame.report.frame);
                require_finite(frame, path);
                OutputFile file(path);
                file.write(frame_head(frame, path.parent_path(), libraries));
                file.write(*connectivity);
                file.commit();
                *bytes += file.bytes_written();
              },
          .finish = [=] { return *bytes; }};
}

}  // namespace flexkey
