#include "flexkey/timeline/read_output.h"

#include <optional>

#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/read_cache_output.h"
#include "flexkey/timeline/read_gltf_output.h"
#include "flexkey/timeline/read_html_output.h"
#include "flexkey/timeline/read_path.h"
#include "flexkey/timeline/read_preview_output.h"

namespace flexkey {

Outputs read_output(const Node& node, Scope& scope) {
  Outputs outputs;
  if (node.kind != Node::Kind::map) {
    outputs.gltf = read_gltf_output(node, "'output'", scope);
    return outputs;
  }
  const std::optional<Fields> fields = read_fields(node, output_keys, "'output'", scope.findings);
  if (const Node* gltf = fields->value("gltf")) outputs.gltf = read_gltf_output(*gltf, "'gltf'", scope);
  outputs.caches = read_cache_outputs(*fields, scope);
  if (const Node* html = fields->value("html")) outputs.html = read_html_output(*html, scope);
  if (const Node* preview = fields->value("preview")) outputs.preview = read_preview_output(*preview, scope);
  if (const Node* report = fields->value("report"))
    outputs.report = {read_path(*report, "'report'", scope).value_or(""), report->where};
  return outputs;
}

}  // namespace flexkey
