#include "flexkey/gltf/source_playback.h"

#include <tiny_gltf.h>

#include <cstddef>
#include <utility>
#include <vector>

#include "flexkey/gltf/accessors.h"
#include "flexkey/gltf/gltf_scene.h"
#include "flexkey/gltf/read_accessor.h"

namespace flexkey {
namespace {

/// One primitive's attribute as a client adds it up.
struct Part {
  Eigen::Matrix4d world;  // from the attribute's space to that of what it is compared with
  FloatRows base;
  std::vector<FloatRows> targets;
};

Positions shown_by(const std::vector<Part>& parts, Eigen::Index count, const Eigen::RowVectorXf& weights) {
  Positions shown(count, 3);
  Eigen::Index row = 0;
  for (const Part& part : parts) {
    FloatRows sum = part.base;
    for (std::size_t t = 0; t < part.targets.size(); ++t) {
      const float weight = weights[static_cast<Eigen::Index>(t)];
      if (weight != 0) sum += weight * part.targets[t];
    }
    const Eigen::Matrix3d linear = part.world.topLeftCorner<3, 3>();
    shown.middleRows(row, sum.rows()) =
        (sum.cast<double>() * linear.transpose()).rowwise() + part.world.topRightCorner<3, 1>().transpose();
    row += sum.rows();
  }
  return shown;
}

/// Rows of a primitive that get targets or none, as rows of the clip's mesh.
struct Side {
  std::size_t node, primitive;
  std::vector<int> rows;
  bool has_targets;
};

std::vector<Side> sides_of(const ExtendedSource& file, const std::string& semantic) {
  std::vector<Side> sides;
  for (std::size_t n = 0; n < file.source.nodes.size(); ++n) {
    const std::vector<SolvedPrimitive>& primitives = file.source.nodes[n].primitives;
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      if (semantic != "POSITION" && !primitives[p].has_normals) continue;
      const PrimitiveSplit& split = file.split.nodes[n][p];
      sides.push_back({n, p, moving_rows(primitives[p], split), true});
      sides.push_back({n, p, still_rows(primitives[p], split), false});
    }
  }
  return sides;
}

std::vector<Part> parts_of(const ExtendedSource& file, const std::string& semantic) {
  const GltfScene scene = parse_gltf_scene(file.source.document.json);
  const AccessorReader reader(scene, file.source.document.bytes);
  std::vector<Part> parts;
  for (Side& side : sides_of(file, semantic)) {
    const SolvedNode& node = file.source.nodes[side.node];
    const GltfMesh& mesh = scene.meshes[static_cast<std::size_t>(node.mesh)];
    for (int& row : side.rows) row -= node.primitives[side.primitive].first_vertex;
    Part part;
    part.world = semantic == "POSITION" ? node.world : Eigen::Matrix4d::Identity();
    const int base = mesh.primitives[side.primitive].attributes.at(semantic);
    part.base = reader.rows(base, 3)(side.rows, Eigen::all).cast<float>();
    if (side.has_targets)
      for (const GltfAttributes& target : file.addition.nodes[side.node].primitives[side.primitive].targets)
        part.targets.push_back(read_rows(file.model, target.at(semantic)));
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace

PlayedAttribute played_by(const ExtendedSource& file, const std::string& semantic) {
  PlayedAttribute played;
  for (const Side& side : sides_of(file, semantic))
    played.vertices.insert(played.vertices.end(), side.rows.begin(), side.rows.end());
  const auto count = static_cast<Eigen::Index>(played.vertices.size());
  played.player = [file, semantic, count]() -> Player {
    return [parts = parts_of(file, semantic), count](const Eigen::RowVectorXf& weights) {
      return shown_by(parts, count, weights);
    };
  };
  return played;
}

}  // namespace flexkey
