#include "flexkey/timeline/read_output.h"

#include <optional>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/read_cache_output.h"
#include "flexkey/timeline/read_gltf_output.h"
#include "flexkey/timeline/read_path.h"
#include "flexkey/timeline/scalar.h"
#include "flexkey/timeline/words.h"

namespace flexkey {
MeshSource read_mesh_source(const Node& node, Scope& scope) {
  using Loose = MeshSource::Loose;
  MeshSource mesh;
  mesh.where = node.where;
  if (node.kind != Node::Kind::map) {
    mesh.file = read_path(node, "'mesh'", scope).value_or("");
    return mesh;
  }
  const std::optional<Fields> fields = read_fields(node, mesh_keys, "'mesh'", scope.findings);
  if (const Node* file = require(*fields, "file", node.where, "'mesh'", scope.findings)) {
    mesh.file = read_path(*file, "'file' in 'mesh'", scope).value_or("");
    mesh.where = file->where;
  }
  if (const Node* loose = fields->value("loose")) {
    mesh.loose =
        read_word<Loose>(*loose, "loose",
                         {{"attach", Loose::attach}, {"hold", Loose::hold}, {"error", Loose::error}}, scope)
            .value_or(Loose::attach);
  }
  if (const Node* weld = fields->value("weld")) mesh.weld = read_distance(*weld, scope).value_or(Length{});
  return mesh;
}

Outputs read_output(const Node& node, Scope& scope) {
  Outputs outputs;
  if (node.kind != Node::Kind::map) {
    outputs.gltf = read_gltf_output(node, "'output'", scope);
    return outputs;
  }
  const std::optional<Fields> fields = read_fields(node, output_keys, "'output'", scope.findings);
  if (const Node* gltf = fields->value("gltf")) outputs.gltf = read_gltf_output(*gltf, "'gltf'", scope);
  outputs.caches = read_cache_outputs(*fields, scope);
  return outputs;
}

}  // namespace flexkey
